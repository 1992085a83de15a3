"""Reads the list of claims, claims.toml, strictly: an invalid entry is an error."""

import decimal
import math
import string
import tomllib

import formula
import judge

CHECK = "implementation check"
REQUIRED = {"id": str, "where": str, "tests": str}
OPTIONAL = {"quote": (str, list), "implied": bool, "kind": str, "claimed": (str, int, float, list), "reading": str,
            "accuracy": (int, float), "accuracy_because": str, "value": str, "get": dict, "choice": list,
            "off_by": (int, float), "off_by_because": str, "brief": str, "note": str, "survives": str, "untestable": str}
CHOICE = {"words": str, "set": dict, "get": dict, "value": str, "claimed": (str, int, float, list)}
SOURCES = {"pulloff": {"pulloff": str, "at": str, "each": dict, "count": bool},
           "case": {"case": str, "when": dict, "at": str, "all": bool, "count": bool},
           "table": {"table": str, "when": dict, "column": str, "all": bool}}
VERBS = ("theory", "solve")


class BookError(Exception):
    """An error in the list, described in one line."""


def demand(holds, where, text):
    if not holds:
        raise BookError(f"{where}: {text}")


def check_source(source, where):
    kinds = [kind for kind in SOURCES if kind in source]
    demand(len(kinds) == 1, where, "expected one of pulloff, case and table")
    allowed = SOURCES[kinds[0]]
    for key, value in source.items():
        demand(key in allowed, where, f"{key} is unknown: expected one of {', '.join(allowed)}")
        demand(isinstance(value, allowed[key]), where, f"{key} is of the wrong type")
    demand(("column" if kinds[0] == "table" else "at") in source, where, "it does not say at which path or column")
    if kinds[0] == "pulloff":
        demand(source["pulloff"].split(" ")[0] in VERBS, where, f"expected a command of {' or '.join(VERBS)}")
        fields = {field for _, field, _, _ in string.Formatter().parse(source["pulloff"]) if field is not None}
        demand(fields == set(source.get("each", {})), where, "the keys in braces are not those of each")


def limits(claimed, where):
    """The claimed interval (low, high), or None for a formula."""
    try:
        if isinstance(claimed, list):
            demand(len(claimed) == 2, where, "claimed: expected a low and a high end")
            low, high = (float(end) for end in claimed)
        else:
            low = high = float(claimed)
    except ValueError:
        demand(isinstance(claimed, str), where, "claimed: expected numbers")
        return None
    demand(low <= high and not math.isnan(low + high), where, "claimed: expected the lower end first")
    return low, high


def quotes(claim):
    """The quoted sentences of a claim."""
    quote = claim.get("quote", [])
    return [quote] if isinstance(quote, str) else quote


def filled(part, given):
    """A source with its {keys} replaced by the values of a choice."""
    if isinstance(part, dict):
        return {key: filled(value, given) for key, value in part.items()}
    if isinstance(part, str):
        for key, value in given.items():
            part = part.replace("{" + key + "}", str(value))
    return part


def choices(claim):
    """The claim for each choice that the paper leaves open, or for itself, with everything that is needed to judge it."""
    made = []
    for choice in claim.get("choice", [{}]):
        get = {name: filled(source, choice.get("set", {}))
               for name, source in {**claim.get("get", {}), **choice.get("get", {})}.items()}
        value = choice.get("value", claim.get("value", next(iter(get), None)))
        made.append({"words": choice.get("words"), "claimed": choice.get("claimed", claim.get("claimed")), "get": get,
                     "value": value})
    return made


def check_choices(claim, where):
    demand(len(claim["choice"]) > 1, where, "choice: expected two or more")
    for place, choice in enumerate(claim["choice"]):
        for key, value in choice.items():
            demand(isinstance(value, CHOICE.get(key, ())), where, f"choice[{place}]: {key} is unknown, or of the wrong type")
        demand(choice.get("words"), where, f"choice[{place}]: words are missing: what is chosen?")


def check_numbers(choice, claim, where):
    """Checks one choice of a claim: the claimed number, the sources, and the formula."""
    demand(choice["claimed"] is not None, where, "claimed is missing")
    got = choice["get"]
    for name, source in got.items():
        check_source(source, f"{where}.get.{name}")
    demand("value" in claim or len(got) == 1 or any("value" in each for each in claim.get("choice", [])), where,
           "value is missing: which of the sources is it?")
    used = formula.names(choice["value"])
    if limits(choice["claimed"], where) is None:
        used |= formula.names(choice["claimed"])
    demand(used <= set(got), where, f"not got: {', '.join(sorted(used - set(got)))}")
    demand(used == set(got), where, f"got for nothing: {', '.join(sorted(set(got) - used))}")
    if claim["reading"] == "printed":
        try:
            is_number = isinstance(choice["claimed"], str) and decimal.Decimal(choice["claimed"]).is_finite()
        except decimal.InvalidOperation:
            is_number = False
        demand(is_number, where, "claimed: expected the number in quotes, as it is printed")


def check_testable(claim, where):
    demand(claim.get("reading") in judge.READINGS, where, f"reading: expected one of {', '.join(judge.READINGS)}")
    if "choice" in claim:
        check_choices(claim, where)
    for choice in choices(claim):
        check_numbers(choice, claim, where)
    if claim["reading"] == "printed":
        demand("accuracy" not in claim, where, "accuracy: the printed digits say it")
    else:
        demand(claim.get("accuracy", -1) >= 0, where, "accuracy is missing, or negative")
        demand("accuracy_because" in claim, where, "accuracy_because is missing")
    if "off_by" in claim:
        demand(claim["off_by"] > 0 and "off_by_because" in claim, where, "off_by: expected a positive number, and off_by_because")


def check_claim(claim, where):
    for key, kind in REQUIRED.items():
        demand(isinstance(claim.get(key), kind) and claim[key], where, f"{key} is missing")
    for key, value in claim.items():
        kind = {**REQUIRED, **OPTIONAL}.get(key)
        demand(kind is not None, where, f"{key} is unknown")
        demand(isinstance(value, kind), where, f"{key} is of the wrong type")
    demand(claim.get("kind", CHECK) == CHECK, where, f"kind: expected {CHECK}, or none")
    demand(quotes(claim) or "kind" in claim, where, "quote is missing: which sentence of the paper says it?")
    demand(all(isinstance(quote, str) for quote in quotes(claim)), where, "quote is of the wrong type")
    if "untestable" in claim:
        demand(not {"claimed", "get", "value", "choice"} & set(claim), where, "untestable, and yet it says how to test it")
    else:
        try:
            check_testable(claim, where)
        except formula.FormulaError as error:
            raise BookError(f"{where}: {error}") from error


def read(path):
    """All claims of a file, checked. Raises a BookError with the position of an error."""
    with open(path, "rb") as stream:
        try:
            book = tomllib.load(stream)
        except tomllib.TOMLDecodeError as error:
            raise BookError(f"{path}: {error}") from error
    demand(set(book) == {"claim"}, path, "expected claims, and nothing else")
    names = [claim.get("id") for claim in book["claim"]]
    for place, claim in enumerate(book["claim"]):
        check_claim(claim, f"{path}: claim {claim.get('id', place + 1)}")
        demand(names.count(claim["id"]) == 1, path, f"claim {claim['id']} is there twice")
    return book["claim"]
