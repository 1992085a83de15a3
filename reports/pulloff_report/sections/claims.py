"""Every claim of the paper beside what was computed, and the command that shows it."""

import math

from . import Section
from ..words import CLAIM_SIGNS, CLAIM_VERDICTS, MINUS, decimals_for, fixed, plain

ABSENT = "The claims of the paper were not judged for this run: ./reproduce --only claims does that."
FEWEST_DECIMALS, MOST_DECIMALS = 3, 8
ORDER = ("contradicted", "within_reading", "reproduced", "not_testable", "no_result")


def decimals_of(claim):
    """Enough to see the difference, or to a tenth of the accuracy; none for what is counted."""
    shown = [abs(claim["difference"] or 0), claim["accuracy"] or 0]
    numbers = [claim[key] for key in ("low", "high", "computed") if claim[key] is not None]
    if not any(shown):
        return 0 if all(number == round(number) for number in numbers) else 4
    smallest = min((value for value in shown if value > 1e-9), default=1e-7)
    return min(max(decimals_for(smallest), FEWEST_DECIMALS), MOST_DECIMALS)


def claimed(claim):
    """What the paper says, as it prints it, or as the number its equation gives."""
    if claim["reading"] == "printed":
        return claim["claimed"].replace("-", MINUS)
    low, high = claim["low"], claim["high"]
    if low == high:
        return "–" if low is None else fixed(low, decimals_of(claim)) if low != round(low) else plain(low)
    if high is None:
        return f"≥ {low:.4g}"
    return f"{low:.4g} to {high:.4g}".replace("-", MINUS)


def sort_key(claim, name):
    value = claim[name]
    return value if value is not None and math.isfinite(value) else ""


def row(claim):
    decimals = None if claim["computed"] is None else decimals_of(claim)
    return {"claim": claim, "claimed": claimed(claim), "rank": ORDER.index(claim["verdict"]), "sort": sort_key,
            "computed": "–" if decimals is None else fixed(claim["computed"], decimals),
            "sign": CLAIM_SIGNS[claim["verdict"]], "word": CLAIM_VERDICTS[claim["verdict"]]}


def build(source):
    judged = source.claims
    data = {"absent": ABSENT, "rows": []}
    if judged:
        counts = [(CLAIM_SIGNS[name], CLAIM_VERDICTS[name], name, judged["counts"].get(name, 0)) for name in CLAIM_VERDICTS]
        data = {"absent": None, "rows": [row(claim) for claim in judged["claims"]],
                "counts": [entry for entry in counts if entry[-1]], "readings": judged["readings"]}
    return Section("claims", "Claims of the paper", "claims.html", data)
