#!/usr/bin/env python3
"""Scores a program on the adhesion sheet. Needs only Python, and problems.json and values.csv beside this file.

    score.py ANSWERS.csv            the correct digits of each problem, and by level
    score.py ANSWERS.csv --json     the same as JSON
    score.py --list                 the problems: id, level, number of quantities, certified digits, title
    score.py --statement ID         the statement of a problem; without ID the definitions that all problems share
    score.py --template             an empty file of answers

ANSWERS.csv has the columns problem, quantity and value; other columns are ignored. An answer that is missing, empty
or no number has no correct digits.

The correct digits of a quantity are the log relative error -log10(|answer - value|/|value|), as in the Statistical
Reference Datasets of NIST, at least 0 and at most the digits that are certified. The correct digits of a problem are
the least of its quantities.
"""

import argparse
import csv
import hashlib
import json
import math
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
LEVELS = ["easy", "average", "hard", "extreme"]
SEAL = "# sha256:"


def read_problems(folder=HERE):
    """The sheet: its name, its definitions and its problems."""
    return json.loads((folder / "problems.json").read_text(encoding="utf-8"))


def read_values(folder=HERE):
    """(certified values {(problem, quantity): row}, checksum). An altered file is an error."""
    lines = (folder / "values.csv").read_text(encoding="utf-8").splitlines(keepends=True)
    text = "".join(line for line in lines if not line.startswith(SEAL))
    stored = [line.split(":")[1].strip() for line in lines if line.startswith(SEAL)]
    checksum = hashlib.sha256(text.encode()).hexdigest()
    if stored != [checksum]:
        raise ValueError(f"values.csv: the checksum of its lines is {checksum}, not that of the line '{SEAL}'")
    rows = csv.DictReader(line for line in lines if not line.startswith("#"))
    return {(row["problem"], row["quantity"]): row for row in rows}, checksum


def read_answers(path, known):
    """{(problem, quantity): number}. A name that the sheet does not have is an error: it is a misprint."""
    answers = {}
    with open(path, encoding="utf-8-sig", newline="") as stream:
        rows = csv.DictReader(line for line in stream if not line.startswith("#"))
        if not {"problem", "quantity", "value"} <= set(rows.fieldnames or []):
            raise ValueError(f"{path}: the columns problem, quantity and value are expected")
        for row in rows:
            key = (row["problem"].strip(), row["quantity"].strip())
            if key not in known:
                raise ValueError(f"{path}: the sheet has no quantity '{key[1]}' of a problem '{key[0]}'")
            if key in answers:
                raise ValueError(f"{path}: '{key[1]}' of '{key[0]}' is answered twice")
            answers[key] = number(row["value"])
    return answers


def number(text):
    """A finite number, or None."""
    try:
        value = float(text)
    except (TypeError, ValueError):
        return None
    return value if math.isfinite(value) else None


def digits(answer, row):
    """The correct digits of one answer."""
    if answer is None:
        return 0.0
    certified, value = float(row["digits"]), float(row["value"])
    difference = abs(answer - value)
    if difference <= float(row["half_width"]):
        return certified
    return min(certified, max(0.0, -math.log10(difference / abs(value))))


def score(sheet, values, answers):
    """One record a problem, in the order of the sheet."""
    records = []
    for problem in sheet["problems"]:
        names = [quantity["name"] for quantity in problem["quantities"]]
        each = {name: digits(answers.get((problem["id"], name)), values[problem["id"], name]) for name in names}
        records.append({"problem": problem["id"], "level": problem["level"], "digits": min(each.values()),
                        "certified": min(float(values[problem["id"], name]["digits"]) for name in names),
                        "answered": sum(answers.get((problem["id"], name)) is not None for name in names),
                        "quantities": each})
    return records


def by_level(records):
    """One record a level: number of problems, of answered ones, and means over all problems of the level."""
    levels = []
    for level in LEVELS:
        here = [record for record in records if record["level"] == level]
        if here:
            levels.append({"level": level, "problems": len(here),
                           "answered": sum(record["answered"] == len(record["quantities"]) for record in here),
                           "digits": sum(record["digits"] for record in here) / len(here),
                           "certified": sum(record["certified"] for record in here) / len(here)})
    return levels


def report(sheet, checksum, records):
    """The result as text."""
    lines = [f"{sheet['name']}  {checksum[:16]}",
             f"{'problem':24} {'level':8} {'correct':>7} {'of':>4}  least certain quantity"]
    for record in records:
        asked, least = record["quantities"], min(record["quantities"], key=record["quantities"].get)
        if record["answered"] == 0:
            remark = "not answered"
        elif record["answered"] < len(asked):
            remark = f"{len(asked) - record['answered']} of {len(asked)} quantities not answered"
        else:
            remark = "" if record["digits"] >= record["certified"] else f"{least} {asked[least]:.1f}"
        lines.append(f"{record['problem']:24} {record['level']:8} {record['digits']:7.1f} {record['certified']:4.0f}  "
                     f"{remark}".rstrip())
    lines.append(f"{'level':8} {'problems':>8} {'answered':>8} {'mean digits':>11} {'of':>4}")
    lines += [f"{one['level']:8} {one['problems']:8} {one['answered']:8} {one['digits']:11.1f} {one['certified']:4.1f}"
              for one in by_level(records)]
    return "\n".join(lines)


def listed(sheet, values):
    """The problems, one a line."""
    lines = []
    for problem in sheet["problems"]:
        certified = [int(values[problem["id"], quantity["name"]]["digits"]) for quantity in problem["quantities"]]
        lines.append(f"{problem['id']:24} {problem['level']:8} {len(certified):2} quantities, "
                     f"{min(certified):2} digits  {problem['title']}")
    return "\n".join(lines)


def statement(sheet, name):
    """The statement of a problem, or the common definitions."""
    if not name:
        return "\n\n".join(sheet["definitions"])
    found = [problem for problem in sheet["problems"] if problem["id"] == name]
    if not found:
        raise ValueError(f"the sheet has no problem '{name}'; --list prints them")
    problem = found[0]
    lines = [f"{problem['id']}: {problem['title']} ({problem['level']})", "", problem["statement"]]
    lines += ["", problem["dimensional"]] if problem["dimensional"] else []
    lines += ["", "Parameters"] + [f"  {key} = {value}" for key, value in problem["parameters"].items()]
    lines += ["", "Asked"] + [f"  {quantity['name']} [{quantity['unit']}]: {quantity['meaning']}; {quantity['sign']}"
                              for quantity in problem["quantities"]]
    return "\n".join(lines)


def template(sheet):
    """An empty file of answers."""
    lines = ["problem,quantity,unit,value"]
    lines += [f"{problem['id']},{quantity['name']},{quantity['unit']},"
              for problem in sheet["problems"] for quantity in problem["quantities"]]
    return "\n".join(lines)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("answers", nargs="?", metavar="ANSWERS.csv")
    parser.add_argument("--json", action="store_true", help="print the score as JSON")
    parser.add_argument("--list", action="store_true", help="print the problems")
    parser.add_argument("--statement", nargs="?", const="", metavar="ID", help="print a statement")
    parser.add_argument("--template", action="store_true", help="print an empty file of answers")
    given = parser.parse_args()
    if sum([given.answers is not None, given.list, given.statement is not None, given.template]) != 1:
        parser.error("one of ANSWERS.csv, --list, --statement and --template is needed")
    return given


def main():
    given = arguments()
    try:
        sheet = read_problems()
        if given.template:
            print(template(sheet))
        elif given.statement is not None:
            print(statement(sheet, given.statement))
        else:
            values, checksum = read_values()
            if given.list:
                print(listed(sheet, values))
                return 0
            records = score(sheet, values, read_answers(given.answers, values))
            result = {"sheet": sheet["name"], "sha256": checksum, "problems": records, "levels": by_level(records)}
            print(json.dumps(result, indent=1) if given.json else report(sheet, checksum, records))
    except (OSError, ValueError) as problem:
        print(f"score.py: {problem}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
