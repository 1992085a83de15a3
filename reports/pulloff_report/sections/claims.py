"""Every claim of the paper beside what was computed, and the command that shows it."""

import math

from . import Section
from ..words import CHECK_VERDICTS, CHOICE_WORDS, CLAIM_SIGNS, CLAIM_VERDICTS, MINUS, decimals_for, fixed, plain, scientific

ABSENT = "The claims of the paper were not judged for this run: ./reproduce --only claims does that."
FEWEST_DECIMALS, MOST_DECIMALS = 3, 8
WORDS = {**CLAIM_VERDICTS, **CHECK_VERDICTS, "depends": "depends"}
ORDER = ("contradicted", "check_failed", "depends", "within_reading", "reproduced", "checked", "not_testable", "no_result")
NOTHING = dict.fromkeys(("words", "claimed", "low", "high", "computed", "difference", "accuracy", "off_by"))


def decimals_of(choice):
    """Enough to see the difference, or to a tenth of the accuracy; none for what is counted."""
    shown = [abs(choice["difference"] or 0), choice["accuracy"] or 0]
    numbers = [choice[key] for key in ("low", "high", "computed") if choice[key] is not None]
    if not choice["accuracy"] and all(number == round(number) for number in numbers):
        return 0
    if not any(shown):
        return 4
    smallest = min((value for value in shown if value > 1e-9), default=1e-7)
    return min(max(decimals_for(smallest), FEWEST_DECIMALS), MOST_DECIMALS)


def claimed(choice, reading):
    """What the paper says, as it prints it, or as the number its equation gives."""
    if reading == "printed":
        return choice["claimed"].replace("-", MINUS)
    low, high = choice["low"], choice["high"]
    if low == high:
        return "–" if low is None else fixed(low, decimals_of(choice)) if low != round(low) else plain(low)
    if high is None:
        return f"≥ {low:.6g}"
    return f"{low:.6g} to {high:.6g}".replace("-", MINUS)


def sort_key(choice, name):
    value = choice[name]
    return value if value is not None and math.isfinite(value) else ""


def amount(choice):
    """By how much a number must be off: in percent, or as a factor from twice on; what is counted in whole numbers."""
    value = choice["off_by"]
    if choice["counted"]:
        return str(max(1, math.floor(value)))
    if value >= 1:
        return f"a factor of {1 + value:.2g}"
    return f"{100 * value:.2g} %" if value >= 1e-4 else scientific(value) + " of itself"


def numbers(choice, reading):
    """What the table shows of one choice."""
    decimals = None if choice["computed"] is None else decimals_of(choice)
    return {"words": choice["words"], "claimed": claimed(choice, reading), "sort": lambda name: sort_key(choice, name),
            "computed": "–" if decimals is None else fixed(choice["computed"], decimals),
            "difference": scientific(choice["difference"])}


def verdict(name, words):
    return {"name": name, "sign": CLAIM_SIGNS[name], "word": words[name]}


def row(claim):
    single = len(claim["choices"]) < 2
    first = claim["choices"][0] if claim["choices"] else NOTHING
    lines = list(dict.fromkeys(line for choice in claim["choices"] for line in choice["commands"]))
    return {"claim": claim, "rank": ORDER.index(claim["verdict"]), "verdict": verdict(claim["verdict"], WORDS),
            "accuracy": first["accuracy"], "commands": lines, "lead": "Implied by" if claim["implied"] else None,
            "off_by": amount(first) if single and first["off_by"] is not None and claim["verdict"] != "contradicted" else None,
            **numbers(first if single else NOTHING, claim["reading"] if single else None),
            "choices": [] if single else [{**numbers(choice, claim["reading"]), "verdict": verdict(choice["verdict"], CHOICE_WORDS)}
                                          for choice in claim["choices"]]}


def build(source):
    judged = source.claims
    data = {"absent": ABSENT, "rows": []}
    if judged:
        words = {**CLAIM_VERDICTS, **CHECK_VERDICTS}
        counts = [(CLAIM_SIGNS[name], words[name], name, judged["counts"].get(name, 0)) for name in words]
        data = {"absent": None, "rows": [row(claim) for claim in judged["claims"]],
                "counts": [entry for entry in counts if entry[-1]], "readings": judged["readings"]}
    return Section("claims", "Claims of the paper", "claims.html", data)
