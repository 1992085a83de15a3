#!/usr/bin/python3
"""Judges every claim of claims.toml with numbers of pulloff and writes the result as JSON (see README.md)."""

import argparse
import hashlib
import json
import math
import os
import sys
import textwrap

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

import book  # noqa: E402
import formula  # noqa: E402
import judge  # noqa: E402
import others  # noqa: E402
import sensitivity  # noqa: E402
import sources  # noqa: E402

SCHEMA = "pulloff-claims/3"
TREE = os.path.dirname(os.path.dirname(HERE))
WORDS = {"within_reading": "reproduced within reading accuracy", "not_testable": "not testable", "no_result": "no result",
         "depends": "depend on a choice", "checked": "implementation checks passed", "check_failed": "implementation checks failed"}
HEAD = ("id", "where", "tests", "kind", "reading", "brief", "note", "survives", "accuracy_because", "off_by_because")


def arguments(words):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default="build/src/cli/pulloff", metavar="FILE", help="the program (default build/src/cli/pulloff)")
    parser.add_argument("--run", default="build/run", metavar="DIR", help="folder of the records of the cases (default build/run)")
    parser.add_argument("--output", metavar="DIR", help="folder for claims.json (default: claims beside the run)")
    parser.add_argument("--list", default=os.path.join(HERE, "claims.toml"), metavar="FILE", help="list of claims (default: claims.toml beside this program)")
    parser.add_argument("--claim", action="append", metavar="ID", help="judge only this claim, and write nothing")
    parser.add_argument("--sensitivity", action="store_true",
                        help="print for each claim the relative change of a number that changes the verdict")
    parser.add_argument("--brief", action="store_true", help="print only the counts, and the entries with a fault or without a number")
    parser.add_argument("--json", action="store_true", help="print one JSON document and nothing else")
    return parser.parse_args(words)


def collect(choice, given):
    """(values by name, commands that compute them)."""
    values, lines = {}, []
    for name, source in choice["get"].items():
        values[name], shown = given.get(source)
        lines += [line for line in shown if line not in lines]
    return values, lines


def judged(choice, claim, given):
    """One choice of a claim with the computed number, the verdict, and the sources that cannot change the verdict."""
    part = {"words": choice["words"], "claimed": choice["claimed"] if isinstance(choice["claimed"], str) else None,
            "low": None, "high": None, "computed": None, "difference": None, "accuracy": None, "off_by": None,
            "counted": all(map(sensitivity.is_count, choice["get"].values())), "unmoved": [], "commands": [], "reason": None}
    bounds = book.limits(choice["claimed"], claim["id"])

    def limits(values):
        return bounds or (formula.evaluate(choice["claimed"], values),) * 2

    try:
        values, part["commands"] = collect(choice, given)
        part["computed"] = formula.evaluate(choice["value"], values)
        part["low"], part["high"] = limits(values)
    except (formula.FormulaError, sources.SourceError) as error:
        return part | {"reason": str(error), "verdict": judge.NO_RESULT}
    part["accuracy"] = judge.half_unit(choice["claimed"]) if claim["reading"] == "printed" else claim["accuracy"]
    part["difference"] = judge.difference(part["computed"], part["low"], part["high"])
    part["verdict"] = judge.verdict(part["computed"], part["low"], part["high"], part["accuracy"], claim["reading"])
    stated = claim.get("off_by") if part["verdict"] in judge.HOLDS else None
    part["off_by"] = stated or sensitivity.derived(part)
    part["unmoved"] = sensitivity.unmoved(choice, values, part["off_by"], limits, part["accuracy"])
    return part


def faults_of(claim, row):
    """The faults of a judged entry: it cannot fail, or it lacks texts that a contradiction requires."""
    found = []
    for part in row["choices"]:
        name = f"choice {part['words']!r}: " if part["words"] else ""
        if part["unmoved"] and part["off_by"] < math.inf:
            found.append(f"{name}the verdict does not change if {', '.join(part['unmoved'])} changes by {part['off_by']:.3g} (relative)")
        if ("off_by" not in claim and not part["counted"] and part["verdict"] in judge.HOLDS
                and part["off_by"] > sensitivity.LARGEST_DERIVED):
            found.append(f"{name}only a relative change by {part['off_by']:.3g} changes the verdict: state off_by and off_by_because")
    if row["verdict"] == judge.CONTRADICTED and not {"brief", "note", "survives"} <= set(claim):
        found.append("contradicted: expected brief, note and survives")
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


def row_of(claim, given, solvers):
    """One claim with its computed numbers, its verdict, and those of the external solvers that can judge it."""
    row = {key: claim.get(key) for key in HEAD}
    row |= {"quotes": book.quotes(claim), "implied": claim.get("implied", False), "choices": [], "faults": [], "solvers": [],
            "reason": claim.get("untestable"), "verdict": judge.NOT_TESTABLE}
    if "untestable" in claim:
        return row
    row["choices"] = [judged(choice, claim, given) for choice in book.choices(claim)]
    row["reason"] = next((part["reason"] for part in row["choices"] if part["reason"]), None)
    row["verdict"] = judge.overall([part["verdict"] for part in row["choices"]], "kind" in claim)
    row["faults"] = faults_of(claim, row)
    row["solvers"] = by_others(claim, solvers)
    return row


def finite(value):
    """The value for JSON, which has no infinity: an open end is null."""
    return None if value in (float("inf"), float("-inf")) else value


def document(rows, digest):
    rows = [{**row, "choices": [{key: finite(value) for key, value in part.items()} for part in row["choices"]]} for row in rows]
    counts = {name: sum(row["verdict"] == name for row in rows) for name in judge.VERDICTS}
    return {"schema": SCHEMA, "list_sha256": digest, "readings": judge.READINGS, "counts": counts, "claims": rows}


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
    lines.append(counts_of(made))
    return "\n".join(lines)


def sensitivity_of(made):
    """The relative change that changes the verdict: one line for each claim and each choice."""
    lines = []
    for row in made["claims"]:
        for part in row["choices"]:
            amount = "-" if part["off_by"] is None else f"{part['off_by']:.3g}"
            fails = "cannot fail: " + ", ".join(part["unmoved"]) if part["unmoved"] else "changes"
            lines.append(f"{row['id']:<34} {amount:>10}  {fails}" + (f"  ({part['words']})" if part["words"] else ""))
    return "\n".join(lines)


def write(path, made):
    beside = f"{path}.{os.getpid()}"
    with open(beside, "w", encoding="utf-8") as stream:
        json.dump(made, stream, indent=1, ensure_ascii=False)
        stream.write("\n")
    os.replace(beside, path)


def main(words):
    wanted = arguments(words)
    output = wanted.output or os.path.join(os.path.dirname(os.path.abspath(wanted.run)), "claims")
    kept = os.path.join(output, "kept")
    try:
        claims = book.read(wanted.list)
        with open(wanted.list, "rb") as stream:
            digest = hashlib.sha256(stream.read()).hexdigest()
        os.makedirs(kept, exist_ok=True)
        given = sources.Sources(os.path.abspath(wanted.program), wanted.run, TREE, kept)
        unknown = set(wanted.claim or ()) - {claim["id"] for claim in claims}
        book.demand(not unknown, wanted.list, f"there is no claim {', '.join(sorted(unknown))}")
        chosen = [claim for claim in claims if not wanted.claim or claim["id"] in wanted.claim]
        given.prepare([source for claim in chosen if "untestable" not in claim
                       for choice in book.choices(claim) for source in choice["get"].values()])
        solvers = others.read(given)
        rows = [row_of(claim, given, solvers) for claim in chosen]
        made = document(rows, digest)
        if not wanted.claim:
            given.forget_unused()
            write(os.path.join(output, "claims.json"), made)
    except book.BookError as error:
        print(f"claims: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"claims: {error.filename}: {error.strerror}", file=sys.stderr)
        return 4
    show = sensitivity_of if wanted.sensitivity else brief_of if wanted.brief else text_of
    print(json.dumps(made, indent=1, ensure_ascii=False) if wanted.json else show(made))
    print(f"{given.seconds:.1f} s in commands that were not kept", file=sys.stderr)
    if made["counts"][judge.NO_RESULT]:
        return 3
    return 1 if any(row["faults"] for row in made["claims"]) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
