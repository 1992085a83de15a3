"""Reads the list of claims of a paper, claims.toml, strictly: an invalid entry is an error. schema() describes the format."""

import collections
import decimal
import itertools
import math
import re
import string
import tomllib

import formula
import judge

CHECK = "implementation check"
REQUIRED = {"id": str, "where": str, "tests": str}
OPTIONAL = {"quote": (str, list), "implied": bool, "kind": str, "claimed": (str, int, float, list), "reading": str,
            "accuracy": (int, float), "accuracy_because": str, "value": str, "get": dict, "choice": list,
            "range": list, "preload": str, "change": dict, "brief": str, "weight": int, "note": str, "survives": str, "untestable": str,
            "reply": str}
CHOICE = {"words": str, "set": dict, "get": dict, "value": str, "claimed": (str, int, float, list), "reading": str,
          "own": (str, type(None)), "preload": int}
MADE = ("own", "preload")   # keys of a choice that with_preloads makes
CHANGE = {"words": str, "swap": list, "get": dict, "value": str, "claimed": (str, int, float, list)}
PRELOAD = {"figures": str, "because": str, "choice": list}
SENTENCE = {"where": str, "quote": str, "entries": list, "words": str}
SURVEY = {"id": str, "figure": str, "words": str, "get": dict, "value": str, "claimed": (int, float), "reading": str, "preloads": list}
Book = collections.namedtuple("Book", "claims preloads surveys sentences")
SOURCES = {"pulloff": {"pulloff": str, "at": str, "each": dict},
           "case": {"case": str, "when": dict, "at": str, "all": bool},
           "table": {"table": str, "when": dict, "column": str, "all": bool}}
VERBS = ("theory", "solve")


class BookError(Exception):
    """An error in the list, described in one line."""


KINDS = {str: "string", int: "integer", float: "number", bool: "boolean", list: "array", dict: "object", type(None): "null"}


def schema():
    """The format of the list as a JSON schema, made from the tables by which the list is checked."""
    def properties(part, needed=()):
        types = {key: [KINDS[kind] for kind in (kinds if isinstance(kinds, tuple) else (kinds,))] for key, kinds in part.items()}
        return {"type": "object", "additionalProperties": False, "required": sorted(needed),
                "properties": {key: {"type": ["integer", "number"] if kinds == ["number"] else kinds} for key, kinds in types.items()}}

    made = {"claim": properties({**REQUIRED, **OPTIONAL}, REQUIRED), "survey": properties(SURVEY, set(SURVEY) - {"claimed", "reading", "value"}),
            "sentence": properties(SENTENCE, SENTENCE)}
    made["claim"]["properties"] |= {
        "kind": {"const": CHECK}, "reading": {"enum": list(judge.READINGS)}, "change": properties(CHANGE, ["words"]),
        "get": {"type": "object", "additionalProperties": {"anyOf": [properties(kind, [name]) for name, kind in SOURCES.items()]}},
        "choice": {"type": "array", "minItems": 2, "items": properties({key: kind for key, kind in CHOICE.items() if key not in MADE}, ["words"])}}
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": "Statements of a paper", "type": "object",
            "additionalProperties": False, "required": ["claim"], "properties": {
                **{name: {"type": "array", "items": part} for name, part in made.items()},
                "preload": {"type": "object", "additionalProperties": properties(PRELOAD, PRELOAD)}}}


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
    """The claimed interval (low, high), or None for a formula. A ratio that is only said to be large has no number."""
    if claimed is None:
        return 1.0, math.inf
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


def is_of_figure(claim):
    """Whether a statement is about a figure of the paper."""
    return "kind" not in claim and bool(re.search(r"\bFigs?\.? ?\d", claim["where"]))


def chosen(claim, *parts):
    """The claim with the sources, the value and the claimed number that some of its parts replace."""
    given = {key: value for part in parts for key, value in part.get("set", {}).items()}
    get = dict(claim.get("get", {}))
    made = {"words": None, "claimed": claim.get("claimed"), "value": claim.get("value"), "reading": claim.get("reading"),
            "own": None, "preload": None}
    for part in parts:
        get |= part.get("get", {})
        made |= {key: part[key] for key in made if key in part}
    get = {name: filled(source, given) for name, source in get.items()}
    return made | {"get": get, "value": made["value"] or next(iter(get), None)}


def choices(claim):
    """The claim for each choice that the paper leaves open, or for itself, with everything that is needed to judge it."""
    return [chosen(claim, choice) for choice in claim.get("choice", [{}])]


def changed(claim):
    """The first choice of a claim, with the physics changed."""
    change = claim["change"]
    made = chosen(claim, claim.get("choice", [{}])[0], change)
    if "swap" in change:
        made["get"] = {name: {**source, "pulloff": source["pulloff"].replace(*change["swap"])} if "pulloff" in source else source
                       for name, source in made["get"].items()}
    return made


def with_preloads(claim, preloads):
    """The claim with one choice for each of its own choices and each preload of its figure. `own`: the words of its own choice;
    `preload`: the place of the preload in the list of its figure."""
    if "preload" not in claim:
        return claim
    mine, listed = claim.get("choice", [{}]), preloads[claim["preload"]]["choice"]
    return {**claim, "choice": [{**own, "words": ", ".join(part["words"] for part in (own, preload) if part),
                                 "own": own.get("words"), "preload": place, "set": {**own.get("set", {}), **preload["set"]}}
                                for own, (place, preload) in itertools.product(mine, enumerate(listed))]}


def check_part(part, known, where):
    """Checks a choice, a change or the preloads of a figure for unknown keys."""
    for key, value in part.items():
        demand(isinstance(value, known.get(key, ())), where, f"{key} is unknown, or of the wrong type")


def check_choices(part, where):
    demand(len(part["choice"]) > 1, where, "choice: expected two or more")
    for place, choice in enumerate(part["choice"]):
        check_part(choice, CHOICE, f"{where}: choice[{place}]")
        demand(choice.get("words"), where, f"choice[{place}]: words are missing: what is chosen?")


def check_change(claim, where):
    change = claim["change"]
    check_part(change, CHANGE, f"{where}: change")
    demand(change.get("words"), where, "change: words are missing: what is changed?")
    made = changed(claim)
    demand(made != {**choices(claim)[0], "words": change["words"]}, where, "change: it changes nothing")
    check_numbers(made, claim, f"{where}: change")


def check_numbers(choice, claim, where):
    """Checks one choice of a claim: the claimed number, the sources, and the formula."""
    demand(choice["reading"] in judge.READINGS, where, f"reading: expected one of {', '.join(judge.READINGS)}")
    demand((choice["claimed"] is None) == (choice["reading"] in judge.UNNUMBERED), where,
           "claimed is missing, or stated for a ratio whose bound is a convention")
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
    stated = claim["reading"] == "equation"
    demand(("accuracy" in claim, "accuracy_because" in claim) == (stated, stated), where,
           "accuracy and accuracy_because: expected for an equation; for other readings the convention says it")
    demand(claim.get("accuracy", 0) >= 0, where, "accuracy is negative")
    demand(("range" in claim) == (claim["reading"] == "axis"), where, "range: expected for an axis, and only there")
    demand("change" in claim or "kind" in claim, where, "change is missing: which change of the physics changes the verdict?")
    if "change" in claim:
        check_change(claim, where)


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


def check_survey(survey, where):
    """A survey: one number at many preloads, and the number of the paper, if it has one."""
    check_part(survey, SURVEY, where)
    demand(set(survey) >= {"id", "figure", "words", "get", "preloads"}, where, "expected id, figure, words, get and preloads")
    demand(("claimed" in survey) == ("reading" in survey), where, "claimed and reading: expected both or none")
    demand(len(survey["preloads"]) > 1 and all(isinstance(words, str) for words in survey["preloads"]), where,
           "preloads: expected two or more texts of options")
    for preload in survey["preloads"]:
        choice = surveyed(survey, preload)
        check_numbers({**choice, "claimed": choice["claimed"] or 0, "reading": choice["reading"] or "about"}, {**survey, "reading": "about"}, where)


def surveyed(survey, preload):
    """The sources and the formula of a survey at one preload."""
    return chosen(survey, {"set": {"preload": preload}}) | {"words": preload_words(preload)[0]}


def preload_words(options):
    """("Δ† = 4", 4.0) or ("load 0.1 πwR", None) for the options of a preload: its words and its approach."""
    found = re.fullmatch(r"--preload(-load)? ([0-9.]+)", options)
    demand(found, options, "expected --preload NUMBER or --preload-load NUMBER")
    return (f"load {found[2]} πwR", None) if found[1] else (f"Δ† = {found[2]}", float(found[2]))


def placeholders(text):
    """The (name, choice) of the numbers that a text contains: {fig10-greatest}, {fig7-limit | A† = 1}."""
    return [tuple(part.strip() for part in found.partition("|")[::2]) for found in re.findall(r"\{([^{}]*)\}", text)]


def check_placeholders(text, claims, surveys, where):
    """The numbers that a text names must be those of entries or surveys."""
    known = {claim["id"]: claim for claim in claims}
    for name, choice in placeholders(text):
        demand(name in known or name in {survey["id"] for survey in surveys}, where, f"{{{name}}} is neither an entry nor a survey")
        demand(choice in ("", "claimed") or name in known and any(choice in (part["words"] or "") for part in choices(known[name])),
               where, f"{name} has no choice {choice}")


def check_sentence(sentence, claims, surveys, where):
    """A sentence of the abstract or the conclusions: the entries that judge it, and the words with their numbers."""
    check_part(sentence, SENTENCE, where)
    demand(set(sentence) == set(SENTENCE), where, f"expected {', '.join(SENTENCE)}")
    names = {claim["id"] for claim in claims}
    for name in sentence["entries"]:
        demand(name in names, where, f"there is no claim {name}")
    check_placeholders(sentence["words"], claims, surveys, where)


def read(path):
    """The Book in a file: all claims, the preloads by figure, the surveys and the sentences, checked. Raises a BookError with the
    position of an error."""
    with open(path, "rb") as stream:
        try:
            book = tomllib.load(stream)
        except tomllib.TOMLDecodeError as error:
            raise BookError(f"{path}: {error}") from error
    demand(set(book) <= {"claim", "preload", "survey", "sentence"} and "claim" in book, path,
           "expected claims, preloads, surveys and sentences, and nothing else")
    preloads, surveys, sentences, claims = book.get("preload", {}), book.get("survey", []), book.get("sentence", []), []
    for name, part in preloads.items():
        check_part(part, PRELOAD, f"{path}: preload {name}")
        demand(set(part) == set(PRELOAD), f"{path}: preload {name}", f"expected {', '.join(PRELOAD)}")
        check_choices(part, f"{path}: preload {name}")
    names = [claim.get("id") for claim in book["claim"]]
    for place, claim in enumerate(book["claim"]):
        where = f"{path}: claim {claim.get('id', place + 1)}"
        demand("preload" not in claim or claim["preload"] in preloads, where, "preload: no such figure")
        claims.append(with_preloads(claim, preloads))
        check_claim(claims[-1], where)
        demand(names.count(claim["id"]) == 1, path, f"claim {claim['id']} is there twice")
    try:
        for place, survey in enumerate(surveys):
            check_survey(survey, f"{path}: survey {survey.get('id', place + 1)}")
    except formula.FormulaError as error:
        raise BookError(f"{path}: {error}") from error
    for claim in claims:
        check_placeholders(claim.get("brief", ""), claims, surveys, f"{path}: claim {claim['id']}")
    for place, sentence in enumerate(sentences):
        check_sentence(sentence, claims, surveys, f"{path}: sentence {place + 1}")
    return Book(claims, preloads, surveys, sentences)
