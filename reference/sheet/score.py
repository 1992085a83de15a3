#!/usr/bin/env python3
"""Scores a program on the adhesion sheet. Needs only Python, and problems.json and values.csv beside this file.

    score.py ANSWERS.csv            the correct digits of each problem, and by level and group
    score.py ANSWERS.csv --verbose  answer, value and digits of every quantity, too
    score.py ANSWERS.csv --json     the score as JSON
    score.py --list                 the checksum, and the problems: id, level, quantities, certified digits, title
    score.py --statement ID         the statement of a problem; without ID the definitions that all problems share
    score.py --statement ID --all   with the definitions, the mistakes that it finds, and how it is certified
    score.py --template             an empty file of answers

ANSWERS.csv has the columns problem, quantity and value, separated by commas, semicolons or tabulators. A column unit
may repeat the units of the sheet; other columns are ignored. An answer that is missing, empty or no number has no
correct digits; those that are no numbers are listed. A name or a unit that the sheet does not have is an error.

The correct digits of a quantity are the log relative error -log10(|answer - value|/|value|), as in the Statistical
Reference Datasets of NIST, at least 0 and at most the digits that are certified. An answer that is no farther from the
value than its half-width has all of these. The correct digits of a problem are the least of its quantities.
"""

import argparse
import csv
import hashlib
import json
import math
import os
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
LEVELS = ["easy", "average", "hard", "extreme"]
SEAL, PROBLEMS = "# sha256:", "# problems:"
DECIMAL = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")


def read_problems(folder=HERE):
    """The sheet: its name, its definitions and its problems."""
    return json.loads((folder / "problems.json").read_text(encoding="utf-8"))


def read_values(folder=HERE):
    """(certified values {(problem, quantity): row}, checksum). An altered file is an error: the checksum is that of
    values.csv, which states that of problems.json."""
    lines = (folder / "values.csv").read_text(encoding="utf-8").splitlines(keepends=True)
    checksum = checksum_of("".join(line for line in lines if not line.startswith(SEAL)))
    if stated(lines, SEAL) != [checksum]:
        raise ValueError(f"values.csv: the checksum of its lines is {checksum}, not that of the line '{SEAL}'")
    problems = checksum_of((folder / "problems.json").read_text(encoding="utf-8"))
    if stated(lines, PROBLEMS) != [problems]:
        raise ValueError(f"problems.json: its checksum is {problems}, not that of the line '{PROBLEMS}' of values.csv")
    rows = csv.DictReader(line for line in lines if not line.startswith("#"))
    return {(row["problem"], row["quantity"]): row for row in rows}, checksum


def checksum_of(text):
    return hashlib.sha256(text.encode()).hexdigest()


def stated(lines, head):
    """What the header lines with this beginning state."""
    return [line.split(":")[1].strip() for line in lines if line.startswith(head)]


def read_answers(path, sheet):
    """({(problem, quantity): number}, answers that are no numbers as texts with their lines). A name that the sheet does
    not have is an error: it is a misprint. So is a unit that is not that of the quantity."""
    units = {(problem["id"], quantity["name"]): quantity["unit"] for problem in sheet["problems"]
             for quantity in problem["quantities"]}
    answers, unread = {}, []
    for place, row in answer_rows(path):
        key = row["problem"], row["quantity"]
        if key not in units:
            raise ValueError(f"{place}: the sheet has no quantity '{key[1]}' of a problem '{key[0]}'")
        if key in answers:
            raise ValueError(f"{place}: '{key[1]}' of '{key[0]}' is answered twice")
        if row.get("unit", "") not in ("", units[key]):
            raise ValueError(f"{place}: '{key[1]}' of '{key[0]}' is asked in {units[key]}, not in {row['unit']}")
        answers[key] = number(row["value"])
        if answers[key] is None and row["value"]:
            unread.append(f"{place}: '{row['value']}' is no number such as -6.2e-7: not answered")
    return answers, unread


def answer_rows(path):
    """Pairs (place in the file, {column: text}) of a file of answers. Commas, semicolons or tabulators separate the columns;
    comments and blank lines are skipped."""
    try:
        text = Path(path).read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as problem:
        raise ValueError(f"{path}: the text is not UTF-8: {problem.reason} at byte {problem.start}") from None
    lines = [(f"{path}, line {i}", line) for i, line in enumerate(text.splitlines(), 1) if line.strip(" ,;\t") and line[0] != "#"]
    head = lines[0][1] if lines else ""
    separator = max(",;\t", key=head.count)
    rows = [(place, [field.strip() for field in next(csv.reader([line], delimiter=separator))]) for place, line in lines]
    columns = [name.lower() for name in rows[0][1]] if rows else []
    if not {"problem", "quantity", "value"} <= set(columns):
        raise ValueError(f"{path}: the columns problem, quantity and value are expected")
    for place, fields in rows[1:]:
        if len(fields) != len(columns):
            raise ValueError(f"{place}: {len(fields)} fields, but {len(columns)} columns ('{separator}' separates them; "
                             "numbers have a decimal point)")
        yield place, dict(zip(columns, fields))


def number(text):
    """A finite decimal number, or None."""
    value = float(text) if DECIMAL.fullmatch(text) else math.inf
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
        records.append({"problem": problem["id"], "level": problem["level"], "group": problem["group"],
                        "digits": min(each.values()),
                        "certified": min(float(values[problem["id"], name]["digits"]) for name in names),
                        "answered": sum(answers.get((problem["id"], name)) is not None for name in names),
                        "quantities": each})
    return records


def means(records, key, names):
    """One record a level or a group: its number of problems, of completely answered ones, and the mean digits over all of
    its problems and over the answered ones."""
    found = []
    for name in names:
        here = [record for record in records if record[key] == name]
        answered = [record["digits"] for record in here if record["answered"] == len(record["quantities"])]
        found.append({key: name, "problems": len(here), "answered": len(answered),
                      "digits": mean([record["digits"] for record in here]), "digits_answered": mean(answered),
                      "certified": mean([record["certified"] for record in here])})
    return [one for one in found if one["problems"]]


def mean(numbers):
    return sum(numbers) / len(numbers) if numbers else None


def scored(sheet, checksum, records, unread):
    """The result as JSON."""
    groups = dict.fromkeys(problem["group"] for problem in sheet["problems"])
    return {"sheet": sheet["name"], "sha256": checksum, "unread": unread, "problems": records,
            "levels": means(records, "level", LEVELS), "groups": means(records, "group", groups)}


def report(result, values, answers, verbose):
    """The result as text."""
    lines = [f"{result['sheet']}  {result['sha256']}", *result["unread"],
             f"{'problem':24} {'level':8} {'correct':>7} {'of':>4}  least certain quantity"]
    for record in result["problems"]:
        lines.append(f"{record['problem']:24} {record['level']:8} {record['digits']:7.1f} {record['certified']:4.0f}  "
                     f"{remark(record)}".rstrip())
        if verbose and record["answered"]:
            lines += [quantity_line(answers.get((record["problem"], name)), found, values[record["problem"], name])
                      for name, found in record["quantities"].items()]
    for key, name in (("level", "levels"), ("group", "groups")):
        lines.append(f"{key:16} {'problems':>8} {'answered':>8} {'mean digits':>11} {'of answered':>11} {'of':>4}")
        for one in result[name]:
            answered = f"{one['digits_answered']:.1f}" if one["answered"] else "-"
            lines.append(f"{one[key]:16} {one['problems']:8} {one['answered']:8} {one['digits']:11.1f} {answered:>11} "
                         f"{one['certified']:4.1f}")
    return "\n".join(lines)


def remark(record):
    """What keeps a problem from its certified digits."""
    asked = record["quantities"]
    least = min(asked, key=asked.get)
    if record["answered"] == 0:
        return "not answered"
    if record["answered"] < len(asked):
        return f"{len(asked) - record['answered']} of {len(asked)} quantities not answered"
    return "" if record["digits"] >= record["certified"] else f"{least} {asked[least]:.1f}"


def quantity_line(answer, found, row):
    """Answer, value and digits of one quantity. A modulus that is right with a wrong sign is pointed out."""
    sign = "  sign?" if answer is not None and found < 1.0 <= digits(-answer, row) else ""
    shown = "-" if answer is None else f"{answer:.12g}"
    return f"  {row['quantity']:22} {shown:>20} {float(row['value']):>20.12g} {found:7.1f} {float(row['digits']):4.0f}{sign}"


def listed(sheet, values, checksum):
    """Name and checksum of the sheet, and the problems, one a line."""
    lines = [f"{sheet['name']}  sha256 {checksum}"]
    for problem in sheet["problems"]:
        certified = [int(values[problem["id"], quantity["name"]]["digits"]) for quantity in problem["quantities"]]
        lines.append(f"{problem['id']:24} {problem['level']:8} {len(certified):2} quantities, "
                     f"{min(certified):2} digits  {problem['title']}")
    return "\n".join(lines)


def statement(sheet, name, everything):
    """The statement of a problem, or the common definitions; everything: both, and the mistakes that the problem finds."""
    if not name:
        return "\n\n".join(sheet["definitions"])
    found = [problem for problem in sheet["problems"] if problem["id"] == name]
    if not found:
        raise ValueError(f"the sheet has no problem '{name}'; --list prints them")
    problem = found[0]
    lines = [*sheet["definitions"], ""] if everything else []
    lines += [f"{problem['id']}: {problem['title']} ({problem['level']})", "", problem["statement"], "", problem["dimensional"]]
    lines += ["", "Parameters"] + [f"  {key} = {value} {problem['parameter_units'][key]}".removesuffix(" 1")
                                   for key, value in problem["parameters"].items()]
    lines += ["", "Asked"] + [f"  {quantity['name']} [{quantity['unit']}]: {quantity['meaning']}; {quantity['sign']}"
                              for quantity in problem["quantities"]]
    lines += ["", f"Finds {problem['catches']}.", f"Certified by {problem['certified']}."] if everything else []
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
    parser.add_argument("--verbose", action="store_true", help="print answer, value and digits of every quantity")
    parser.add_argument("--list", action="store_true", help="print the problems")
    parser.add_argument("--statement", nargs="?", const="", metavar="ID", help="print a statement")
    parser.add_argument("--all", action="store_true", help="with --statement: the definitions and what it finds, too")
    parser.add_argument("--template", action="store_true", help="print an empty file of answers")
    given = parser.parse_args()
    if sum([given.answers is not None, given.list, given.statement is not None, given.template]) != 1:
        parser.error("one of ANSWERS.csv, --list, --statement and --template is needed")
    return given


def output(given):
    """The text that is asked for."""
    sheet = read_problems()
    if given.template:
        return template(sheet)
    if given.statement is not None:
        return statement(sheet, given.statement, given.all)
    values, checksum = read_values()
    if given.list:
        return listed(sheet, values, checksum)
    answers, unread = read_answers(given.answers, sheet)
    result = scored(sheet, checksum, score(sheet, values, answers), unread)
    return json.dumps(result, indent=1) if given.json else report(result, values, answers, given.verbose)


def main():
    given = arguments()
    try:
        print(output(given), flush=True)
    except BrokenPipeError:             # the reader has read enough, as head does
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except (OSError, ValueError) as problem:
        print(f"score.py: {problem}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
