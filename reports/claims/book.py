"""The list of claims, claims.toml: read strictly, so that a wrong entry is told and not passed over."""

import decimal
import math
import string
import tomllib

import formula
import judge

REQUIRED = {"id": str, "where": str, "says": str}
OPTIONAL = {"claimed": (str, int, float, list), "reading": str, "accuracy": (int, float), "accuracy_because": str,
            "value": str, "unit": str, "note": str, "get": dict, "untestable": str}
SOURCES = {"pulloff": {"pulloff": str, "at": str, "each": dict}, "case": {"case": str, "when": dict, "at": str, "all": bool},
           "table": {"table": str, "when": dict, "column": str, "all": bool}}
VERBS = ("theory", "solve")


class BookError(Exception):
    """What is wrong with the list, in one line."""


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
    """(low, high) of what is claimed; None for a formula."""
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


def value_of(claim):
    """The formula of the computed number: what is said, or else the only source."""
    return claim.get("value") or next(iter(claim["get"]))


def check_testable(claim, where):
    for key in ("claimed", "reading"):
        demand(key in claim, where, f"{key} is missing")
    demand(claim["reading"] in judge.READINGS, where, f"reading: expected one of {', '.join(judge.READINGS)}")
    got = claim.get("get", {})
    for name, source in got.items():
        check_source(source, f"{where}.get.{name}")
    demand("value" in claim or len(got) == 1, where, "value is missing: which of the sources is it?")
    used = formula.names(value_of(claim))
    if limits(claim["claimed"], where) is None:
        used |= formula.names(claim["claimed"])
    demand(used <= set(got), where, f"not got: {', '.join(sorted(used - set(got)))}")
    demand(used == set(got), where, f"got for nothing: {', '.join(sorted(set(got) - used))}")
    if claim["reading"] == "printed":
        demand("accuracy" not in claim, where, "accuracy: the printed digits say it")
        try:
            is_number = isinstance(claim["claimed"], str) and decimal.Decimal(claim["claimed"]).is_finite()
        except decimal.InvalidOperation:
            is_number = False
        demand(is_number, where, "claimed: expected the number in quotes, as it is printed")
    else:
        demand(claim.get("accuracy", -1) >= 0, where, "accuracy is missing, or negative")
        demand("accuracy_because" in claim, where, "accuracy_because is missing")


def check_claim(claim, where):
    for key, kind in REQUIRED.items():
        demand(isinstance(claim.get(key), kind) and claim[key], where, f"{key} is missing")
    for key, value in claim.items():
        kind = {**REQUIRED, **OPTIONAL}.get(key)
        demand(kind is not None, where, f"{key} is unknown")
        demand(isinstance(value, kind), where, f"{key} is of the wrong type")
    if "untestable" in claim:
        demand(not {"claimed", "get", "value"} & set(claim), where, "untestable, and yet it says how to test it")
    else:
        try:
            check_testable(claim, where)
        except formula.FormulaError as error:
            raise BookError(f"{where}: {error}") from error


def read(path):
    """All claims of a file, checked. BookError says where it is wrong."""
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
