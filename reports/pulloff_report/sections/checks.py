"""Every check of the run: computed value, expected value, error relative to the tolerance, verdict."""

import math

from . import Section
from .cases import shown
from ..records import PASSING
from ..references import file_name
from ..words import VERDICT_MEANINGS, decimals_for, quantity, sweep_label

GROUP_BY = ("quantity", "reference", "because", "kind", "tolerance", "ledger")


def width_of(ratio):
    """Length of the bar of a ratio in percent, on a logarithmic scale from 1e-4 to 1."""
    if ratio is None:
        return None
    if ratio >= 1:
        return 100
    return round(100 * max(0.02, 1 + math.log10(max(ratio, 1e-4)) / 4), 1)


def detail(check):
    """The last part of the id of a check, such as "jump_in-1/approach"; its group and point are shown elsewhere."""
    parts = check["id"].split("/", 3)
    return parts[3].replace("_", " ") if len(parts) > 3 else ""


def absolute_tolerance(check):
    if check["kind"] == "rel" and check["expected"]:
        return check["tolerance"] * abs(check["expected"])
    return check["tolerance"] if check["kind"] == "abs" else None


def decimals_of(check):
    """Decimals that show two digits of the tolerance; 0 for counts, None if the expected value is 0."""
    if check["quantity"].endswith("_count") or check["quantity"].startswith("work_"):
        return 0
    if check["expected"] == 0:
        return None
    return decimals_for(absolute_tolerance(check))


def row(case, check, shown_ids):
    point = case.point(check.get("point"))
    return {"check": check, "label": sweep_label(point), "detail": detail(check),
            "decimals": decimals_of(check), "bar": width_of(check["ratio"]), "passes": check["verdict"] in PASSING,
            "point_id": f"point-{case.name}-{point['id']}" if point and point["id"] in shown_ids else None}


def groups(case):
    """The checks of a case; those that differ only in their point share a heading."""
    found = {}
    shown_ids = {point["id"] for point in shown(case)}
    for check in case.checks:
        key = tuple(str(check.get(name)) for name in GROUP_BY)
        found.setdefault(key, {"first": check, "quantity": quantity(check["quantity"]),
                               "reference": file_name(check.get("reference")), "rows": []})
        found[key]["rows"].append(row(case, check, shown_ids))
    return list(found.values())


def build(source):
    tables = [{"case": case, "groups": groups(case)} for case in source.run.cases]
    ledgers = sorted({check["ledger"] for check in source.run.checks()})
    found = {check["verdict"] for check in source.run.checks()}
    verdicts = [name for name in VERDICT_MEANINGS if name in found]
    return Section("checks", "Every check", "checks.html",
                   {"tables": tables, "ledgers": ledgers, "verdicts": verdicts}, on_paper=False,
                   omitted_words=f"all {len(source.run.checks())} checks with computed and expected value, error and tolerance, "
                   "and the reason of the tolerance; the table can be searched and sorted")
