#!/usr/bin/python3
"""Compares the JSON Schema of the documents (doc/pulloff-1.schema.json) with real output and with doc/json.md.

Usage: schema.py PROGRAM SOURCE_TREE PAGE

- Every document that the commands below print or write must be valid, and every property of the schema must occur in
  one of them, so that no property of an earlier version is left.
- The schema must reject an added key, a missing key and a value of a wrong type: each document is changed in these
  three ways. Under the sanitizers (RUN_FEW) it is not: the program has no part in that.
- The Python function doc/examples/digest.py must give the digests of the documents.
- PAGE, doc/json.md as it is built, must have a row for every key of every definition, and no others. Of results in SI units it states a rule.

Exit status: 0 all hold, 1 otherwise, 77 python3-jsonschema is not installed.
"""

import copy
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import digest
from tally import Tally, errors, has_error

try:
    import jsonschema
except ImportError:
    print("skipped: there is no jsonschema (Debian: python3-jsonschema)")
    sys.exit(77)

SI = "--from-physical --modulus-pa 2e9 --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 1e-7"
WAVY_SI = f"{SI} --amplitude-m 1e-10 --wavelength-m 3e-9"
LENGTHS = "--outer-radius-m 2e-7 --approach-start-m -3e-9 --approach-end-m 1e-10"
WAVES = "--amplitude 1 --wavelength 20"
SOLVES = [
    ("", 0),
    ("--tabor 0", 0),
    ("--tabor 0 --want diagnostics,hysteresis,preload,curve,profile", 0),
    ("--scheme ring --nodes 101 --want curve,profile,hysteresis,diagnostics,preload", 0),
    ("--scheme triangle --nodes 101 --grading graded", 0),
    ("--tabor 2.385 --preload 0.7 --want curve,profile,hysteresis,diagnostics,preload", 0),
    ("--tabor 3 --outer-radius 100 --approach-end -3", 0),
    ("--tabor 2 --stiffness 0.05 --want preload,curve", 0),
    ("--tabor 0.5 --viscoelastic gamma:0.3,0.6 --unload-speed 5 --tolerance 1e-4 --want history", 0),
    ("--tabor 0.5 --viscoelastic sls:0.3 --unload-speed 5 --load-speed 5 --dwell 1 --tolerance 1e-4 --want history", 0),
    (f"{SI} --tolerance 1e-4 --viscoelastic sls:0.5 --relaxation-time-s 1e-3 --unload-speed-m-per-s 1e-6 --load-speed-m-per-s 1e-6 --dwell-s 1e-3 --want history", 0),
    (f"--tabor 3 {WAVES} --tolerance 1e-4 --want hysteresis,preload,profile", 0),
    (f"--tabor 3 {WAVES} --tolerance 1e-4 --preload inf --want theories", 0),
    ("--from-physical --modulus-pa 5e9 --work-j-per-m2 0.08 --distance-m 3e-10 --radius-m 3e-8 --want theories", 0),
    ("--from-physical --modulus-pa 1.58e6 --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 45e-9 --tolerance 1e-3 --want theories", 0),
    ("--from-physical --young-pa 160e9,5e9+-1e8 --poisson 0.22,0.4 --work-j-per-m2 0.08 --distance-m 3e-10 --radius-m 3e-8,6e-8 --tolerance 1e-4", 0),
    ("--from-physical --young-pa 5e9 --poisson 0.4 --surface-energies-j-per-m2 0.05,0.05+-1e-3,0.02 --distance-m 3e-10 --profile punch:1e-9,5e-9 --tolerance 1e-4", 0),
    ("--profile power:0.005,2 --radius 100 --tolerance 1e-4", 0),
    ("--profile-file table.csv --radius 100 --outer-radius 40 --tolerance 1e-4", 0),
    ("--tabor 3 --time-limit 1e-9", 3),
    ("--tabor 1 --preload -5", 3),
    (f"{SI} --want curve,profile --profile-approach-m -3e-10", 0),
    (f"{WAVY_SI} {LENGTHS} --tolerance 1e-4", 0),
    (f"{SI} --profile-file metres.csv --wave 1e-11,3e-9 --outer-radius-m 1e-8 --preload-m 1e-10 --tolerance 1e-4", 0),
    (f"{SI} --profile power:5e6,2 --tolerance 1e-4", 0),
    ("--from-physical --modulus-pa 7e5 --work-j-per-m2 0.03 --distance-m 3e-10 --radius-m 0.0125 --tolerance 1e-2 --range reduced --want hysteresis,preload", 0),
    (f"{SI} --preload-load-n 2e-9 --stiffness-n-per-m 2 --tolerance 1e-4 --want curve,loop,preload,diagnostics", 0),
    ("--from-physical --modulus-pa 2e9 --work-j-per-m2 0.05+-0.005 --distance-m 3e-10 --profile-file metres.csv --table-scale 1 --smooth auto "
     "--outer-radius-m 1e-8 --preload-m 1e-10 --tolerance 1e-4", 0),
]
THEORIES = [
    "bradley --approach -0.5", f"rigid {WAVES} --approach -0.5", "jkr --tabor 3 --contact-radius 20", "dmt --tabor 3 --contact-radius 20",
    f"guduru --tabor 3 {WAVES} --contact-radius 20", f"kesari-lew --tabor 3 {WAVES} --contact-radius 20",
    f"persson-tosatti --tabor 3 {WAVES}", "rumpf-rabinowicz --alpha 1", f"compactness {WAVES}", f"crest {WAVES}",
    "lennard-jones --gap 0.2", "kesari-lew --tabor 3 --amplitude 0", "crest --amplitude 0",
    f"bradley {SI} --approach-m -1e-10", f"rigid {WAVY_SI} --approach-m -1e-10", f"jkr {SI} --contact-radius-m 6e-9",
    f"guduru {WAVY_SI} --contact-radius-m 6e-9", f"kesari-lew {WAVY_SI} --contact-radius-m 6e-9",
    f"persson-tosatti {WAVY_SI}", f"rumpf-rabinowicz {WAVY_SI}", f"compactness {WAVY_SI}", f"crest {WAVY_SI}",
    f"lennard-jones {SI} --gap 0.2", "jkr --from-physical --young-pa 5e9 --poisson 0.4 --work-j-per-m2 0.08 --distance-m 3e-10 --radius-m 3e-8,6e-8",
    "jkr --profile cone:0.3 --coupling 0.05 --contact-radius 3",
    "maugis --tabor 1 --contact-radius 9", f"jkr {SI} --wave 1e-10,5e-9 --contact-radius-m 6e-9",
    f"guduru {WAVY_SI} --preload-load-n 1e-9 --load-n 0", "jkr --curve curve.csv", f"jkr {SI} --approach-m 0", "dmt --load 0", "maugis --load 0",
    "persson-brener --tabor 3 --viscoelastic sls:0.2 --unload-speed 1", "persson-brener --tabor 3 --viscoelastic sls:0.2 --unload-speed inf",
    f"persson-brener {SI} --viscoelastic sls:0.2 --unload-speed-m-per-s 1e-9 --relaxation-time-s 1",
    f"guduru --tabor 3 {WAVES} --preload-load 1 --load -0.3", f"jkr --tabor 3 {WAVES} --preload 1",
    f"maugis {SI} --contact-radius-m 6e-9", "rigid --law morse:2 --approach 0.1",
]
FOLLOWS = ["--key tabor --from 1 --to 2 --points 4", "--key tabor --from 2 --to 0.5 --points 5 --of folds",
           "--key tabor --from 0 --to 1 --points 2 --scale linear",
           "--from-physical --key radius-m --from 1e-8 --to 2e-8 --points 3 --modulus-pa 2e9 --work-j-per-m2 0.05 "
           "--distance-m 3e-10"]
CASES = {
    "mixed": ("""
scene: {outer_radius: inf, scheme: triangle, nodes: 101, radius: 100}
sweep:
  - {key: tabor, values: [1, 2.385]}
  - together: [{approach_start: -8, approach_end: 1}, {approach_start: -12}]
leave_out: [{when: [{key: tabor, values: [2.385]}, {key: approach_start, values: [-8]}], because: why not}]
lines: [{name: smooth, theory: jkr, sweep: [{key: tabor, values: [1, 2]}]}]
want: [pull_off, curve, profile]
repeats: 2
checks:
  - {quantity: pull_off_force, reference: reference/feng_pull_off.csv, tolerance: 1e-4, kind: abs, because: b,
     when: [{key: tabor, values: [1]}]}
  - {quantity: pull_off_force, reference: reference/published/none.csv, stand_in: reference/feng_pull_off.csv,
     tolerance: 1e-2, kind: abs, because: b}
measure: [{quantity: curve, reference: reference/feng_curves.csv}]
""", 1),
    "followed": ("""
scene: {radius: 93, outer_radius: 80, scheme: panel, tolerance: 1e-4, wavelength: 21, amplitude: 1}
sweep: [{key: tabor, from: 0.5, to: 0.7, count: 6}]
follow: tabor
traced: {seed: 3, count: 2}
want: [pull_off]
checks: [{quantity: pull_off_force, reference: traced, tolerance: 1e-3, kind: abs, because: b}]
""", 0),
    "physical": ("""
scene:
  physical: {modulus_pa: 2e9, work_j_per_m2: 0.05, distance_m: 3e-10, radius_m: 1e-7}
  scheme: panel
  tolerance: 1e-4
sweep: [{key: time_limit, values: [100, 1e-9]}]
want: [pull_off, loop, diagnostics, preload, theories]
checks: [{quantity: solved_share, reference: every_scene, tolerance: 0.4, kind: abs, because: b}]
""", 3),
    "soft": ("""
scene:
  physical: {modulus_pa: 7e5, work_j_per_m2: 0.03, distance_m: 3e-10, radius_m: 0.0125}
  scheme: panel
  tolerance: 1e-3
  range: reduced
want: [pull_off]
""", 0),
    "drawn": ("""
scene: {outer_radius: inf, scheme: panel, tolerance: 1e-4}
sample: {seed: 5, count: 2, keys: [{key: tabor, from: 0.7, to: 1.3}, {key: radius, from: 70, to: 200}]}
want: [pull_off]
""", 0),
}

# An external solver, which knows one of the points of `mixed`.
SOLVER = """
protocol: pulloff-ask/1
solver: good
command: [/usr/bin/python3, '%s', '%s', '%s', '{request}', '{response}']
can:
  scene: [{key: tabor, to: 1.5}, {key: radius}, {key: outer_radius}]
  quantities: [pull_off_force, pull_off_approach]
  unstable: true
knob: {name: nodes, values: [3, 7]}
"""


class Tests(Tally):
    def __init__(self, program, root, folder):
        self.program, self.folder = program, folder
        self.environment = dict(os.environ, PULLOFF_DATA=str(root))
        schema = json.loads((root / "doc/pulloff-1.schema.json").read_text())
        jsonschema.Draft202012Validator.check_schema(schema)
        self.definitions = schema["$defs"]
        self.unseen = {(name, key) for name, d in self.definitions.items() for key in d.get("properties", {})}

    def run(self, arguments, code=0):
        ended = subprocess.run([self.program, *arguments.split()], cwd=self.folder, env=self.environment,
                               capture_output=True, text=True)
        self.tell(arguments, ended.returncode != code and f"exit status {ended.returncode}: {ended.stderr}")
        return ended.stdout

    def valid(self, definition, text, what):
        document = json.loads(text)
        self.tell(f"{what}: valid", "; ".join(errors(self.definitions, definition, document)[:3]))
        self.note(definition, document)
        self.sealed(document, what)
        for spoil in () if "RUN_FEW" in os.environ else (add_key, drop_key, retype):
            spoilt = copy.deepcopy(document)
            spoil(spoilt)
            self.tell(f"{what}: {spoil.__name__} is found", not has_error(self.definitions, definition, spoilt) and "valid")

    def sealed(self, document, what):
        """The digest of a document, and those of the points of a record, by the function of doc/examples/digest.py."""
        of = digest.function()
        if document["schema"] == "pulloff-record/1":
            self.tell(f"{what}: digest", document["digest"] != of([point["digest"] for point in document["points"]]))
            keys = self.definitions["result"]["properties"]
            for point in document["points"]:
                self.tell(f"{what}: digest of point {point['id']}", point["digest"] != digest.of_result(point, keys))
        elif "digest" in document:
            self.tell(f"{what}: digest", document["digest"] != of(document) and of(document))

    def note(self, definition, value):
        """Removes the properties of a value from those that have not occurred yet."""
        self.note_schema(self.definitions[definition], value, definition)

    def note_schema(self, schema, value, name=None):
        if "$ref" in schema:
            self.note(schema["$ref"].rpartition("/")[2], value)
        for part in (*schema.get("oneOf", ()), *schema.get("allOf", ())):
            self.note_schema(part, value)
        if isinstance(value, list) and "items" in schema:
            for item in value:
                self.note_schema(schema["items"], item)
        if isinstance(value, dict):
            for key, inner in schema.get("properties", {}).items():
                if key in value:
                    self.unseen.discard((name, key))
                    self.note_schema(inner, value[key])

    def documented(self, page):
        """The tables of doc/json.md. The first cell of the first row names the definitions, the others keys."""
        rows, names = {}, None
        for line in page.read_text().splitlines():
            cells = re.match(r"\| (`[^|]*`) \|", line)
            words = re.findall(r"`([^`]+)`", cells[1]) if cells else []
            if not line.startswith("|"):
                names = None
            elif words and names is None:
                names = words
            elif names:
                for name in names:
                    rows.setdefault(name, []).extend(words)
                keys = {key for name in names for key in self.definitions.get(name, {}).get("properties", ())}
                self.tell(f"{page.name}: {names}", sorted(set(words) - keys))
        for name, definition in self.definitions.items():
            if re.match(r"(record_)?physical(?!_input)", name):
                continue
            lacking = sorted(set(definition.get("properties", ())) - set(rows.get(name, ())))
            self.tell(f"{page.name}: rows of {name}", lacking and f"keys without a row: {lacking}")
            twice = sorted({key for key in rows.get(name, ()) if rows[name].count(key) > 1})
            self.tell(f"{page.name}: rows of {name}", twice and f"twice: {twice}")
        self.tell("tables of definitions", sorted(set(rows) - set(self.definitions)))


def add_key(document):
    document["one_more"] = 0


def drop_key(document):
    del document["schema"]


def retype(document):
    """Replaces the last value that is a list or an object by a text."""
    key = [key for key, value in document.items() if isinstance(value, (list, dict))] or [*document][1:]
    document[key[-1]] = {"not": "this"} if isinstance(document[key[-1]], (list, float)) else "not this"


def main():
    program, root = os.path.realpath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        tests = Tests(program, root, folder)
        rows = "\n".join(f"{r},{r * r / 200}" for r in range(0, 60, 2))
        pathlib.Path(folder, "table.csv").write_text(f"r,gap\n{rows}\n")
        rows = "\n".join(f"{r}e-10,{5e-14 * r * r}" for r in range(0, 120, 4))
        pathlib.Path(folder, "metres.csv").write_text(f"r,gap\n{rows}\n")
        for flags, code in SOLVES:
            tests.valid("solve", tests.run(f"solve {flags} --json", code), f"solve {flags}")
        for flags in THEORIES:
            tests.valid("theory", tests.run(f"theory {flags} --json"), f"theory {flags}")
        for flags in FOLLOWS:
            tests.valid("follow", tests.run(f"follow {flags} --json"), f"follow {flags}")
        tests.valid("list", tests.run("list --json"), "list")
        tests.valid("plan", tests.run("plan --json smoke fig04"), "plan")
        tests.valid("references", tests.run("list --references --json"), "list --references")
        for name, (text, code) in CASES.items():
            path = pathlib.Path(folder, f"{name}.yaml")
            path.write_text(f"name: {name}\ntitle: A small case\nsuites: [smoke]\n{text}")
            tests.run(f"verify {path.name} --output run", code)
            tests.valid("record", pathlib.Path(folder, f"run/{name}/record.json").read_text(), f"record of {name}")
            record = json.loads(pathlib.Path(folder, f"run/{name}/record.json").read_text())
            planned = json.loads(tests.run(f"plan {path.name} --json"))
            tests.tell(f"plan in the record of {name}", record["plan"] != planned["cases"][0]["plan"])
            explained = tests.run(f"explain {path.name} --output run --all --json", code)
            tests.valid("explain", explained, f"explain {name}")
        root_words = f"{root}/tests/cli/responder.py", "good", f"{root}/reference/feng_pull_off.csv"
        pathlib.Path(folder, "solver.yaml").write_text(SOLVER % root_words)
        tests.run("run mixed.yaml --solver solver.yaml --output run")
        tests.valid("record", pathlib.Path(folder, "run/solvers/good/mixed/record.json").read_text(), "record of a solver")
        tests.run("run mixed.yaml --solver solver.yaml --output some --points 0")
        tests.valid("record", pathlib.Path(folder, "some/solvers/good/mixed/part.json").read_text(), "record of one point")
    tests.tell("every property was seen", sorted(map(".".join, tests.unseen - NOT_HERE)))
    tests.documented(pathlib.Path(sys.argv[3]))
    return tests.end()


# The first key says why a table is damaged, and the tables of the source tree are intact; a case has no uncertain inputs.
NOT_HERE = {("listed_table", "reason"), ("record_physical", "uncertainty"), ("record_physical", "interpolation"), ("record_physical", "unloading"), ("record_physical", "parabola")}

if __name__ == "__main__":
    sys.exit(main())
