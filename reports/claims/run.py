#!/usr/bin/python3
"""Judges every claim of claims.toml by numbers of pulloff, and writes them as JSON (README.md says what is in it)."""

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
import sources  # noqa: E402

SCHEMA = "pulloff-claims/1"
TREE = os.path.dirname(os.path.dirname(HERE))
WORDS = {"within_reading": "reproduced within reading accuracy", "not_testable": "not testable", "no_result": "no result"}


def arguments(words):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default="build/src/cli/pulloff", metavar="FILE", help="the program (build/src/cli/pulloff)")
    parser.add_argument("--run", default="build/run", metavar="DIR", help="the records of the cases (build/run)")
    parser.add_argument("--output", metavar="DIR", help="where claims.json goes (claims beside the run)")
    parser.add_argument("--list", default=os.path.join(HERE, "claims.toml"), metavar="FILE", help="another list of claims")
    parser.add_argument("--claim", action="append", metavar="ID", help="only this claim; writes nothing")
    parser.add_argument("--json", action="store_true", help="one JSON document on standard output, nothing else")
    return parser.parse_args(words)


def collect(claim, given):
    """(values by name, the lines that show them)."""
    values, lines = {}, []
    for name, source in claim.get("get", {}).items():
        values[name], shown = given.get(source)
        lines += [line for line in shown if line not in lines]
    return values, lines


def row_of(claim, given):
    """One claim with what was computed, and its verdict."""
    row = {key: claim.get(key) for key in ("id", "where", "says", "reading", "unit", "note", "accuracy_because")}
    row |= {"claimed": None, "low": None, "high": None, "computed": None, "difference": None, "accuracy": None,
            "commands": [], "reason": claim.get("untestable"), "verdict": judge.NOT_TESTABLE}
    if "untestable" in claim:
        return row
    row["claimed"] = claim["claimed"] if isinstance(claim["claimed"], str) else None
    try:
        values, row["commands"] = collect(claim, given)
        computed = formula.evaluate(book.value_of(claim), values)
        low, high = book.limits(claim["claimed"], claim["id"]) or (formula.evaluate(claim["claimed"], values),) * 2
    except (formula.FormulaError, sources.SourceError) as error:
        return row | {"reason": str(error), "verdict": judge.NO_RESULT}
    accuracy = judge.half_unit(claim["claimed"]) if claim["reading"] == "printed" else claim["accuracy"]
    return row | {"low": low, "high": high, "computed": computed, "accuracy": accuracy,
                  "difference": judge.difference(computed, low, high),
                  "verdict": judge.verdict(computed, low, high, accuracy, claim["reading"])}


def finite(value):
    """JSON knows no infinity: an open end is null."""
    return None if value in (float("inf"), float("-inf")) else value


def document(rows, digest):
    rows = [{key: finite(value) for key, value in row.items()} for row in rows]
    counts = {name: sum(row["verdict"] == name for row in rows) for name in judge.VERDICTS}
    return {"schema": SCHEMA, "list_sha256": digest, "readings": judge.READINGS, "counts": counts, "claims": rows}


def text_of(made):
    """The table for a terminal: a line a claim, and the counts."""
    lines = []
    for row in made["claims"]:
        numbers = ["-" if row[key] is None else f"{row[key]:.9g}" for key in ("low", "high", "computed", "difference")]
        claimed = numbers[0] if numbers[0] == numbers[1] else f"{numbers[0]}..{numbers[1]}"
        lines.append(f"{row['id']:<34} {claimed:>22} {numbers[2]:>16} {numbers[3]:>16}  {row['verdict']}")
        if row["verdict"] == judge.NO_RESULT:
            lines += textwrap.wrap(row["reason"], 110, initial_indent="    ", subsequent_indent="    ")
    lines.append(", ".join(f"{number} {WORDS.get(name, name)}" for name, number in made["counts"].items() if number))
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
        rows = [row_of(claim, given) for claim in claims if not wanted.claim or claim["id"] in wanted.claim]
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
    print(json.dumps(made, indent=1, ensure_ascii=False) if wanted.json else text_of(made))
    print(f"{given.seconds:.1f} s in commands that were not kept", file=sys.stderr)
    return 3 if made["counts"][judge.NO_RESULT] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
