"""Checks by case: for each case how many checks pass, the largest error relative to its tolerance, and the verdict."""

from . import Section
from .. import findings
from ..words import VERDICT_MEANINGS


def build(source):
    rows = findings.rows(source.run)
    found = {check["verdict"] for check in source.run.checks()}
    meanings = [(name, text) for name, text in VERDICT_MEANINGS.items() if name in found]
    return Section("verdicts", "Checks by case", "verdicts.html",
                   {"rows": rows, "totals": findings.totals(rows), "meanings": meanings})
