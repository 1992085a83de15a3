"""Every claim of the paper with the computed number, the verdict, and the command that computes the number."""

import math

from . import Section
from ..words import CHECK_VERDICTS, CHOICE_WORDS, CLAIM_SIGNS, CLAIM_VERDICTS, MINUS, decimals_for, fixed, plain, scientific

ABSENT = "the claims of the paper (./reproduce --only claims)"
# The groups of the tables, in reading order: (identifier, title, verdicts, whether the HTML page shows it unfolded).
GROUPS = (("contradicted", "Contradicted statements", ("contradicted", "check_failed"), True),
          ("depends", "Statements that depend on a choice that the paper leaves open", ("depends", "no_result"), True),
          ("holds", "Statements that hold, in the order of the paper", ("reproduced", "within_reading"), False),
          ("others", "Implementation checks and statements that cannot be tested", ("checked", "not_testable"), False))
# On paper this group is without the implementation checks, which say nothing about the paper.
PAPER_TITLES = {"others": "Statements that cannot be tested"}
FEWEST_DECIMALS, MOST_DECIMALS = 3, 8
WORDS = {**CLAIM_VERDICTS, **CHECK_VERDICTS, "depends": "depends on a choice"}
# The words of the narrow columns of the paper edition.
SHORT_WORDS = {"within_reading": "reproduced*", "checked": "check passed", "check_failed": "check failed"}
SHORT_CHOICE_WORDS = {"within_reading": "holds*"}
PASSES = ("reproduced", "within_reading", "checked")
ORDER = ("contradicted", "check_failed", "depends", "within_reading", "reproduced", "checked", "not_testable", "no_result")
LONGEST_QUOTE = 80
NOTHING = dict.fromkeys(("words", "claimed", "low", "high", "computed", "difference", "accuracy"))


def decimals_of(choice):
    """Decimals that show the difference, or a tenth of the accuracy; 0 for counts."""
    shown = [abs(choice["difference"] or 0), choice["accuracy"] or 0]
    numbers = [choice[key] for key in ("low", "high", "computed") if choice[key] is not None]
    if not choice["accuracy"] and all(number == round(number) for number in numbers):
        return 0
    if not any(shown):
        return 4
    smallest = min((value for value in shown if value > 1e-9), default=1e-7)
    return min(max(decimals_for(smallest), FEWEST_DECIMALS), MOST_DECIMALS)


def claimed(choice, reading):
    """The claimed number: as the paper prints it, or as its equation evaluates."""
    if reading == "printed":
        return choice["claimed"].replace("-", MINUS)
    low, high = choice["low"], choice["high"]
    if low == high:
        return "–" if low is None else fixed(low, decimals_of(choice)) if low != round(low) else plain(low)
    if high is None:
        return f"≥ {low:.6g}"
    digits = 2 if reading == "order" else 6
    return f"{low:.{digits}g} to {high:.{digits}g}".replace("-", MINUS)


def sort_key(choice, name):
    value = choice[name]
    return value if value is not None and math.isfinite(value) else ""


def change_of(claim):
    """"100 elements: 1.484, does not hold"; None for a claim without a change of the physics."""
    change = claim["change"]
    return change and f"{change['words']}: {words_of(change)}, {CHOICE_WORDS[change['verdict']]}"


def numbers(choice, reading):
    """The columns of one choice."""
    decimals = None if choice["computed"] is None else decimals_of(choice)
    return {"words": choice["words"], "claimed": claimed(choice, reading), "sort": lambda name: sort_key(choice, name),
            "computed": "–" if decimals is None else fixed(choice["computed"], decimals),
            "difference": scientific(choice["difference"])}


def verdict(name, words):
    return {"name": name, "sign": CLAIM_SIGNS[name], "word": words[name]}


def choice_row(choice, reading):
    return {**numbers(choice, reading), "verdict": verdict(choice["verdict"], CHOICE_WORDS),
            "short": verdict(choice["verdict"], {**CHOICE_WORDS, **SHORT_CHOICE_WORDS})}


def preload_of(choice):
    """"pressed to Δ† = 10" of "λ† = 20, pressed to Δ† = 10"."""
    return choice["words"].removeprefix(f"{choice['own']}, ") if choice["own"] else choice["words"]


def choice_rows(claim):
    """One row for each choice; the preloads at which one choice has the same numbers are one row."""
    rows, of_own = [], {}
    for choice in claim["choices"]:
        of_own[choice["own"]] = of_own.get(choice["own"], 0) + 1
        made = choice_row(choice, choice["reading"])
        key = (choice["own"], *(made[name] for name in ("claimed", "computed", "difference")), made["verdict"]["name"])
        same = next((row for row in rows if row["key"] == key and choice["preload"] is not None), None)
        if same:
            same["preloads"].append(preload_of(choice))
        else:
            rows.append({**made, "key": key, "own": choice["own"], "preloads": [preload_of(choice)]})
    for row in rows:
        if len(row["preloads"]) > 1:
            every = len(row["preloads"]) == of_own[row["own"]]
            words = f"at all {len(row['preloads'])} preloads" if every else row["preloads"][0] + "".join(
                f" or {words.removeprefix('pressed ')}" for words in row["preloads"][1:])
            row["words"] = f"{row['own']}, {words}" if row["own"] else words
    return rows


def by_solvers(claim):
    """"2 of 3 external solvers, not by wrong (-2)"; None if none can judge the claim."""
    solvers = claim["solvers"]
    if not solvers:
        return None
    other = [f"{entry['name']} ({words_of(entry)})" for entry in solvers if entry["verdict"] not in PASSES]
    return (f"{len(solvers) - len(other)} of {len(solvers)} external solvers" + (", not by " + ", ".join(other) if other else ""))


def words_of(entry):
    return "no result" if entry["computed"] is None else f"{entry['computed']:.4g}".replace("-", MINUS)


def of_all(choices, name):
    """A column of a row in which all choices stand together: "1.946", or "3.259 to 3.722"."""
    by = {"claimed": "low"}.get(name, name)
    cells = list(dict.fromkeys(choice[name] for choice in sorted(choices, key=lambda choice: choice["sort"](by) or -math.inf)))
    return cells[0] if len(cells) == 1 else f"{cells[0]} to {cells[-1]}"


def shortened(quotes):
    """The beginning of the first quoted sentence, for the narrow tables of the paper edition."""
    text = quotes[0] if quotes else ""
    return text if len(text) <= LONGEST_QUOTE else text[:LONGEST_QUOTE].rsplit(" ", 1)[0] + " …"


def table_of(robust, preloads):
    """The robust counts: one row for each convention, one cell for each preload, if the list has any, and for all of them."""
    words = {"half": "half the accuracy", "once": "the convention", "twice": "twice the accuracy"}
    return [(words[scale], [cell for cell in robust["table"] if cell["scale"] == scale and (preloads or cell["preload"] is None)]) for scale in words]


def row(claim):
    single = len(claim["choices"]) < 2
    first = claim["choices"][0] if claim["choices"] else NOTHING
    choices = [] if single else choice_rows(claim)
    lines = list(dict.fromkeys(line for choice in claim["choices"] for line in choice["commands"]))
    return {"claim": claim, "rank": ORDER.index(claim["verdict"]), "verdict": verdict(claim["verdict"], WORDS),
            "short": verdict(claim["verdict"], {**WORDS, **SHORT_WORDS}),
            "accuracy": first["accuracy"], "commands": lines, "by_solvers": by_solvers(claim), "lead": "Implied by" if claim["implied"] else None,
            "change": change_of(claim), "quote": shortened(claim["quotes"]),
            **numbers(first if single else NOTHING, claim["reading"] if single else None),
            "choices": choices, "together": {name: of_all(choices, name) for name in ("claimed", "computed")} if choices else None}


def build(source):
    judged = source.claims
    data, entries = {}, []
    if judged:
        words = {**CLAIM_VERDICTS, **CHECK_VERDICTS}
        counts = [(CLAIM_SIGNS[name], words[name], name, judged["counts"].get(name, 0)) for name in words]
        found = [{"id": f"claims-{name}", "title": title, "paper_title": PAPER_TITLES.get(name, title), "is_open": is_open, "detailed": is_open,
                  "rows": [row(claim) for claim in judged["claims"] if claim["verdict"] in verdicts]}
                 for name, title, verdicts, is_open in GROUPS]
        data = {"groups": [group for group in found if group["rows"]],
                "counts": [entry for entry in counts if entry[-1]], "readings": judged["readings"], "preloads": judged["preloads"],
                "robust": judged["robust"], "table": table_of(judged["robust"], judged["preloads"]),
                "unseen": sum(claim["figure"] for claim in judged["claims"]),
                "decided": [claim for claim in judged["claims"] if claim["decided"]],
                "by_solvers": sum(bool(claim["solvers"]) for claim in judged["claims"]), "number": len(judged["claims"])}
        entries = [(group["id"], f"{group['title']} ({len(group['rows'])})") for group in data["groups"]]
    return Section("claims", "Claims of the paper", "claims.html", data, entries, absent="" if judged else ABSENT)
