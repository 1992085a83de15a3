#!/bin/sh
# pulloff list --references prints the tables, their numbers of rows and the cases that use them, as in the files.
# shellcheck disable=SC1091,SC2154
. "$(dirname "$0")/lib.sh"
python=${PYTHON:-python3}
root=$(cd "$here/../.." && pwd)
export PULLOFF_DATA="$root"

expect 0 '' list --references
cp "$work/stdout" list.text
expect 0 '' list --references --json
cp "$work/stdout" list.json
cat >look.py <<'LOOK'
import glob, json, os, re, sys

root = sys.argv[1]
uses = {}
for path in sorted(glob.glob(os.path.join(root, "cases", "*.yaml"))):
    text = open(path, encoding="utf-8").read()
    section = re.search(r"^checks:\n((?:[ #].*\n|\n|- .*\n)*)", text, re.MULTILINE)
    for name in re.findall(r'reference: *"?([^,}\s#"]+)', section.group(1) if section else ""):
        uses.setdefault(name, set()).add(re.search(r"^name: *(\S+)", text, re.MULTILINE).group(1))
tables = {}
for pattern in ("reference/*.csv", "reference/published/*.csv", "reference/sheet/*.csv"):
    for path in glob.glob(os.path.join(root, pattern)):
        lines = open(path, encoding="utf-8").read().splitlines()
        head = dict(line[2:].split(": ", 1) for line in lines if line.startswith("# ") and ": " in line)
        tables[os.path.relpath(path, root)] = (head["kind"], sum(not line.startswith("#") for line in lines) - 1)
listed = json.load(open("list.json"))["references"]
assert {entry["table"] for entry in listed} == set(tables), set(tables) ^ {entry["table"] for entry in listed}
text = {line.split()[0]: line.split() for line in open("list.text")}
assert sum(len(names) for names in uses.values()) > 20
for entry in listed:
    name = entry["table"]
    assert entry["intact"] and entry["in_index"], entry
    assert (entry["kind"], entry["rows"]) == tables[name], (entry, tables[name])
    assert entry["cases"] == sorted(uses.get(name, ())), (entry, uses.get(name))
    kind, rows, cases, state = text[name][1:5]
    assert (kind, int(rows)) == tables[name] and state == "intact", text[name]
    shown = [] if cases == "-" else cases.split(",")
    assert shown == entry["cases"][:len(shown)] and (shown or not entry["cases"]), (text[name], entry)
LOOK
check 'the list agrees with the files' "$python" look.py "$root"

# The case general has the scene of every row of the general table, so a row that is added needs its scene there. LJ is
# the Mie law (3, 9), also in a reference.
rows=$(($(grep -vc '^#' "$root/reference/general_pull_off.csv") - 1))
expect 0 '' plan general
check 'general has every scene of its table' \
  grep -q "compare pull_off_force with reference/general_pull_off.csv at $rows of $rows points" stdout
check 'every scene of general has its row' sh -c '! grep -q "has no value" stdout'
cat >mie.yaml <<'CASE'
name: mie
title: The Lennard-Jones law by its powers
suites: [smoke]
scene: {law: "mie:3,9", radius: 100, outer_radius: inf, scheme: panel, tabor: 1}
want: [pull_off]
checks:
  - {quantity: pull_off_force, reference: reference/feng_pull_off.csv, tolerance: 1e-6, kind: abs, because: the same law}
CASE
expect 0 'mie: *' verify mie.yaml --output out
check 'the Mie law (3, 9) is compared with the tables of Lennard-Jones' grep -q '1 check passes' stdout
finish
