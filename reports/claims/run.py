#!/usr/bin/python3
"""Judges every claim of claims.toml with numbers of pulloff and writes the result as JSON (see README.md)."""

import argparse
import hashlib
import json
import os
import sys
import textwrap

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

import book  # noqa: E402
import formula  # noqa: E402
import judge  # noqa: E402
import others  # noqa: E402
import robust  # noqa: E402
import sources  # noqa: E402

SCHEMA = "pulloff-claims/5"
TREE = os.path.dirname(os.path.dirname(HERE))
PAPER = os.path.join(TREE, "reports", "papers", "wavy_sphere")   # the paper that the report is about
LIST = os.path.join(PAPER, "claims.toml")
WORDS = {"within_reading": "reproduced within reading accuracy", "not_testable": "not testable", "no_result": "no result",
         "depends": "depend on a choice", "checked": "implementation checks passed", "check_failed": "implementation checks failed"}
HEAD = ("id", "where", "tests", "kind", "reading", "brief", "weight", "note", "survives", "reply")


def arguments(words):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default="build/src/cli/pulloff", metavar="FILE", help="the program (default build/src/cli/pulloff)")
    parser.add_argument("--paper", default=PAPER, metavar="DIR",
                        help="folder of a paper, with claims.toml and, in run, the records of its cases (default: that of the report)")
    parser.add_argument("--run", metavar="DIR", help="folder of the records of the cases (default build/run, or run in the folder of the paper)")
    parser.add_argument("--output", metavar="DIR", help="folder for claims.json (default: claims beside the run)")
    parser.add_argument("--list", metavar="FILE", help="list of claims (default: claims.toml in the folder of the paper)")
    parser.add_argument("--schema", action="store_true", help="print the format of the list as a JSON schema, and nothing else")
    parser.add_argument("--claim", action="append", metavar="ID", help="judge only this claim, and write nothing")
    parser.add_argument("--changes", action="store_true",
                        help="print for each claim the number with changed physics, and whether the verdict changes")
    parser.add_argument("--brief", action="store_true", help="print only the counts, and the entries with a fault or without a number")
    parser.add_argument("--json", action="store_true", help="print one JSON document and nothing else")
    wanted = parser.parse_args(words)
    wanted.list = wanted.list or os.path.join(wanted.paper, "claims.toml")
    wanted.run = wanted.run or ("build/run" if wanted.paper == PAPER else os.path.join(wanted.paper, "run"))
    return wanted


def collect(choice, given):
    """(values by name, commands that compute them)."""
    values, lines = {}, []
    for name, source in choice["get"].items():
        values[name], shown = given.get(source)
        lines += [line for line in shown if line not in lines]
    return values, lines


def judged(choice, claim, given):
    """One choice of a claim with the computed number and the verdict. `decided`: half or twice the accuracy of the
    convention would change the verdict."""
    claim = {**claim, "reading": choice["reading"]}
    part = {"words": choice["words"], "own": choice["own"], "preload": choice["preload"],
            "reading": choice["reading"], "verdicts": dict.fromkeys(judge.SCALES, judge.NO_RESULT),
            "claimed": choice["claimed"] if isinstance(choice["claimed"], str) else None,
            "low": None, "high": None, "computed": None, "difference": None, "accuracy": None, "decided": False,
            "commands": [], "reason": None}
    try:
        values, part["commands"] = collect(choice, given)
        part["computed"] = formula.evaluate(choice["value"], values)
        ends = book.limits(choice["claimed"], claim["id"]) or (formula.evaluate(choice["claimed"], values),) * 2
    except (formula.FormulaError, sources.SourceError) as error:
        return part | {"reason": str(error), "verdict": judge.NO_RESULT}

    def verdict_of(scale):
        low, high, accuracy = judge.reach(claim, choice["claimed"], *ends, scale, part["computed"])
        return low, high, accuracy, judge.verdict(part["computed"], low, high, accuracy, claim["reading"])

    part["low"], part["high"], part["accuracy"], part["verdict"] = verdict_of(1.0)
    part["difference"] = judge.difference(part["computed"], part["low"], part["high"])
    part["verdicts"] = {name: verdict_of(scale)[-1] for name, scale in judge.SCALES.items()}
    part["decided"] = len(set(part["verdicts"].values())) > 1
    return part


def change_of(claim, row, given):
    """The first choice of a claim with changed physics, and whether its verdict moved; None for a check without a change."""
    if "change" not in claim:
        return None
    part = judged(book.changed(claim), claim, given)
    verdicts = {row["choices"][0]["verdict"], part["verdict"]}
    moved = judge.NO_RESULT not in verdicts and len({verdict in judge.HOLDS for verdict in verdicts}) == 2
    return {**{key: part[key] for key in ("words", "computed", "verdict", "reason", "commands")}, "moved": moved}


def faults_of(claim, row):
    """The faults of a judged entry: it cannot fail, or it lacks texts that a contradiction requires."""
    found, change = [], row["change"]
    if change and not change["moved"] and row["verdict"] != judge.NO_RESULT:
        found.append(f"the verdict does not change with {change['words']}" + (f": {change['reason']}" if change["reason"] else ""))
    if row["verdict"] == judge.CONTRADICTED and not {"brief", "weight", "note", "survives"} <= set(claim):
        found.append("contradicted: expected brief, weight, note and survives")
    return found


def by_others(claim, solvers):
    """The verdicts of the external solvers that can judge a claim, each with its first computed number."""
    choices, found = book.choices(claim), []
    for solver in solvers:
        if solver.can_judge(choices):
            parts = [judged(choice, claim, solver) for choice in choices]
            found.append({"name": solver.name, "verdict": judge.overall([part["verdict"] for part in parts], "kind" in claim),
                          "computed": parts[0]["computed"]})
    return found


def why(claim):
    """The reason for the accuracy of an entry: its own, or the convention of its reading."""
    if claim.get("reading") == "axis":
        return f"2 % of the range from {claim['range'][0]} to {claim['range'][1]}".replace("-", "−")
    return claim.get("accuracy_because") or judge.READINGS.get(claim.get("reading"))


def row_of(claim, given, solvers):
    """One claim with its computed numbers, its verdict, and those of the external solvers that can judge it."""
    row = {key: claim.get(key) for key in HEAD}
    row |= {"accuracy_because": why(claim), "quotes": book.quotes(claim), "implied": claim.get("implied", False),
            "figure": book.is_of_figure(claim), "choices": [], "change": None, "decided": False, "faults": [], "solvers": [],
            "reason": claim.get("untestable"), "verdict": judge.NOT_TESTABLE}
    if "untestable" in claim:
        return row
    row["choices"] = [judged(choice, claim, given) for choice in book.choices(claim)]
    row["reason"] = next((part["reason"] for part in row["choices"] if part["reason"]), None)
    row["verdict"] = judge.overall([part["verdict"] for part in row["choices"]], "kind" in claim)
    row["decided"] = robust.moves(row)
    row["change"] = change_of(claim, row, given)
    row["faults"] = faults_of(claim, row)
    row["solvers"] = by_others(claim, solvers)
    return row


def survey_of(survey, given):
    """A survey: its number at every preload, None where it has none, and whether the number of the paper is reproduced there by each convention."""
    numbered = survey if "reading" in survey else {**survey, "claimed": 0, "reading": "about"}
    parts = [judged(book.surveyed(numbered, preload), {"id": survey["id"], **numbered}, given) for preload in survey["preloads"]]
    return {"id": survey["id"], "figure": survey["figure"], "words": survey["words"], "claimed": survey.get("claimed"),
            "tried": [{"words": part["words"], "approach": book.preload_words(preload)[1], "computed": part["computed"],
                       "holds": {name: "reading" in survey and verdict in judge.HOLDS for name, verdict in part["verdicts"].items()}}
                      for part, preload in zip(parts, survey["preloads"])]}


def finite(value):
    """The value for JSON, which has no infinity: an open end is null."""
    return None if value in (float("inf"), float("-inf")) else value


def document(rows, digest, preloads, surveys=(), sentences=()):
    """All that is written: the judged claims, and what follows from them (robust.py). `surveys`: judged surveys."""
    rows = [{**row, "choices": [{key: finite(value) for key, value in part.items()} for part in row["choices"]]} for row in rows]
    rows = [{**row, "brief": robust.filled(row["brief"], rows, surveys)} for row in rows]
    counts = {name: sum(row["verdict"] == name for row in rows) for name in judge.VERDICTS}
    return {"schema": SCHEMA, "list_sha256": digest, "readings": judge.READINGS, "counts": counts, "claims": rows,
            "robust": robust.counts(rows), "surveys": list(surveys), "common": robust.common(surveys),
            "sentences": [robust.sentence(entry, rows, surveys) for entry in sentences],
            "preloads": [{"figures": part["figures"], "because": part["because"], "words": [choice["words"] for choice in part["choice"]]}
                         for part in preloads.values()]}


def line_of(name, part, verdict):
    numbers = ["-" if part[key] is None else f"{part[key]:.9g}" for key in ("low", "high", "computed", "difference")]
    claimed = numbers[0] if numbers[0] == numbers[1] else f"{numbers[0]}..{numbers[1]}"
    return f"{name:<34} {claimed:>22} {numbers[2]:>16} {numbers[3]:>16}  {verdict}"


def solvers_of(row):
    """How many of the solvers that can judge a claim reproduce it."""
    other = [entry["name"] for entry in row["solvers"] if entry["verdict"] not in judge.PASSES]
    told = f"reproduced by {len(row['solvers']) - len(other)} of {len(row['solvers'])} external solvers"
    return told + (f"; not by {', '.join(other)}" if other else "")


def counts_of(made):
    return ", ".join(f"{number} {WORDS.get(name, name)}" for name, number in made["counts"].items() if number)


def brief_of(made):
    """The entries with a fault or without a number, each with the command that shows it, and the counts."""
    lines = [f"{row['id']}: {text}\n    /usr/bin/python3 reports/claims/run.py --claim {row['id']}"
             for row in made["claims"]
             for text in row["faults"] + ([row["reason"]] if row["verdict"] == judge.NO_RESULT else [])]
    return "\n".join([*lines, f"{len(made['claims'])} claims: {counts_of(made)}"])


def text_of(made):
    """The table for a terminal: one line for each claim and each choice, and the counts."""
    nothing = dict.fromkeys(("low", "high", "computed", "difference"))
    lines = []
    for row in made["claims"]:
        single = len(row["choices"]) == 1
        lines.append(line_of(row["id"], row["choices"][0] if single else nothing, row["verdict"]))
        if not single:
            lines += [line_of("  " + part["words"], part, part["verdict"]) for part in row["choices"]]
        problems = row["faults"] + ([row["reason"]] if row["verdict"] == judge.NO_RESULT else [])
        for text in problems + ([solvers_of(row)] if row["solvers"] else []):
            lines += textwrap.wrap(text, 110, initial_indent="    ", subsequent_indent="    ")
    lines += [counts_of(made), *robust.text_of(made)]
    return "\n".join(lines)


def changes_of(made):
    """The number with changed physics: one line for each claim, then the claims whose verdict a convention decides."""
    lines = [line_of(row["id"], {**row["choices"][0], "computed": row["change"]["computed"], "difference": None},
                     f"{'changes' if row['change']['moved'] else 'STAYS'}: {row['change']['words']}")
             for row in made["claims"] if row["change"]]
    return "\n".join([*lines, "decided by the convention: " + ", ".join(row["id"] for row in made["claims"] if row["decided"])])


def write(path, made):
    beside = f"{path}.{os.getpid()}"
    with open(beside, "w", encoding="utf-8") as stream:
        json.dump(made, stream, indent=1, ensure_ascii=False)
        stream.write("\n")
    os.replace(beside, path)


def main(words):
    wanted = arguments(words)
    if wanted.schema:
        print(json.dumps(book.schema(), indent=1, ensure_ascii=False))
        return 0
    output = wanted.output or os.path.join(os.path.dirname(os.path.abspath(wanted.run)), "claims")
    kept = os.path.join(output, "kept")
    try:
        claims, preloads, surveys, sentences = book.read(wanted.list)
        with open(wanted.list, "rb") as stream:
            digest = hashlib.sha256(stream.read()).hexdigest()
        os.makedirs(kept, exist_ok=True)
        given = sources.Sources(os.path.abspath(wanted.program), wanted.run, TREE, kept, wanted.paper)
        unknown = set(wanted.claim or ()) - {claim["id"] for claim in claims}
        book.demand(not unknown, wanted.list, f"there is no claim {', '.join(sorted(unknown))}")
        chosen = [claim for claim in claims if not wanted.claim or claim["id"] in wanted.claim]
        given.prepare([source for claim in chosen if "untestable" not in claim
                       for choice in book.choices(claim) + ([book.changed(claim)] if "change" in claim else [])
                       for source in choice["get"].values()]
                      + [source for survey in (() if wanted.claim else surveys) for preload in survey["preloads"]
                         for source in book.surveyed(survey, preload)["get"].values()])
        solvers = others.read(given)
        rows = [row_of(claim, given, solvers) for claim in chosen]
        made = document(rows, digest, preloads, *(((), ()) if wanted.claim else (
            [survey_of(survey, given) for survey in surveys], sentences)))
        if not wanted.claim:
            given.forget_unused()
            write(os.path.join(output, "claims.json"), made)
    except book.BookError as error:
        print(f"claims: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"claims: {error.filename}: {error.strerror}", file=sys.stderr)
        return 4
    show = changes_of if wanted.changes else brief_of if wanted.brief else text_of
    print(json.dumps(made, indent=1, ensure_ascii=False) if wanted.json else show(made))
    print(f"{given.seconds:.1f} s in commands that were not kept", file=sys.stderr)
    if made["counts"][judge.NO_RESULT]:
        return 3
    return 1 if any(row["faults"] for row in made["claims"]) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
