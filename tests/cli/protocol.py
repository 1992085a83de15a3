#!/usr/bin/python3
"""Compares the protocol of external solvers (doc/solvers.md, doc/pulloff-ask-1.schema.json) with the program.

Usage: protocol.py PROGRAM SOURCE_TREE

- The examples of the page are valid. The program accepts the manifest of the page, and takes its answers.
- Every manifest of reference/solvers is valid, and accepted.
- A request that the program writes is valid, and its table has the same points.
- The answers of a solver of reference/solvers are valid.
- The page has a row for every key of the manifest, of a request and of an answer.

Exit status: 0 all hold, 1 otherwise, 77 python3-jsonschema or python3-yaml is not installed.
"""

import csv
import glob
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from tally import Tally, errors

try:
    import jsonschema
    import yaml
except ImportError as missing:
    print(f"skipped: {missing} (Debian: python3-jsonschema, python3-yaml)")
    sys.exit(77)

SCENES = """
protocol: pulloff-ask/1
solver: recorder
command: [/bin/sh, -c, 'exit 7', '{request}', '{table}', '{response}']
can:
  scene: [{key: tabor, from: 0.3}, {key: radius}, {key: outer_radius}]
  quantities: [pull_off_force, curve, folds]
  unstable: true
knob: {name: nodes, values: [63, 127]}
time_limit: 1
"""


class Tests(Tally):
    def __init__(self, program, root):
        self.program, self.root = program, root
        self.schema = json.loads((root / "doc/pulloff-ask-1.schema.json").read_text())
        jsonschema.Draft202012Validator.check_schema(self.schema)
        self.page = (root / "doc/solvers.md").read_text()

    def valid(self, definition, document, what):
        self.tell(what, "; ".join(errors(self.schema["$defs"], definition, document)[:3]))

    def run(self, *words):
        return subprocess.run([self.program, *words], capture_output=True, text=True,
                              env=dict(os.environ, PULLOFF_DATA=str(self.root)))

    def blocks(self, language):
        return re.findall(rf"^```{language}\n(.*?)^```$", self.page, re.M | re.S)

    def page_examples(self):
        manifest, = self.blocks("yaml")
        self.valid("manifest", yaml.load(manifest, yaml.BaseLoader), "the manifest of the page")
        pathlib.Path("page.yaml").write_text(manifest.replace("octave-cli, '{here}/answer.m'", "/bin/false, -"))
        pathlib.Path("influence.m").write_text("")
        self.tell("the program takes the manifest of the page",
                  (ended := self.run("conform", "page.yaml")).returncode != 1 and ended.stderr)
        request, *answers = self.blocks("json")
        self.valid("request", json.loads(request), "the request of the page")
        for answer in answers:
            self.valid("answer", json.loads(answer), "an answer of the page")
        # the program reads the answer of the page as the one to a point of its own
        answer = json.loads(answers[0]) | {"id": "0"}
        pathlib.Path("answer.jsonl").write_text(json.dumps(answer) + "\n")
        pathlib.Path("taken.yaml").write_text(SCENES.replace("exit 7", f'cat "{os.getcwd()}/answer.jsonl" >$2'))
        printed = self.run("conform", "taken.yaml").stdout
        self.tell("the program takes the answer of the page",
                  "answered; force 2.65, expected" not in printed and printed)

    def manifests(self):
        for path in sorted(glob.glob(str(self.root / "reference/solvers/*.yaml"))):
            with open(path, encoding="utf-8") as stream:
                self.valid("manifest", yaml.load(stream, yaml.BaseLoader), path)

    def requests(self):
        pathlib.Path("recorder.yaml").write_text(SCENES)
        printed = self.run("conform", "recorder.yaml", "--output", "out").stdout
        folder = re.search(r"request and response are in (.*)", printed)
        self.tell("the folder of a failed process is kept", not folder and printed)
        if not folder:
            return None
        folder = pathlib.Path(folder[1])
        request = json.loads((folder / "request.json").read_text())
        self.valid("request", request, "a request")
        with open(folder / "request.csv", encoding="utf-8") as stream:
            rows = list(csv.DictReader(stream))
        points = request["points"]
        self.tell("the table has the points of the request", len(rows) != len(points) and f"{rows}")
        for row, point in zip(rows, points):
            same = (row["id"] == point["id"] and float(row["tabor"]) == point["scene"]["tabor"]
                    and row["nodes"] == "127" and point["knob"] == {"nodes": 127}
                    and float(row["preload_load"]) == point["preload"]["load"])
            self.tell(f"point {point['id']} in the table", not same and f"{row} {point}")
        return request

    def answers(self, request):
        request = request | {"points": [point | {"knob": {"nodes": 63}} for point in request["points"][-1:]]}
        pathlib.Path("request.json").write_text(json.dumps(request))
        subprocess.run([sys.executable, self.root / "reference/solvers/newton.py", "request.json", "response.jsonl"],
                       check=True, env=dict(os.environ, PYTHONDONTWRITEBYTECODE="1", OMP_NUM_THREADS="1"))
        lines = pathlib.Path("response.jsonl").read_text().splitlines()
        self.tell("one line a point", len(lines) != 1 and f"{len(lines)} lines")
        for line in lines:
            self.valid("answer", json.loads(line), f"an answer {line[:80]}")

    def rows_of_page(self):
        named = set(re.findall(r"`([a-z_.]+)`", self.page))
        definitions = self.schema["$defs"]
        keys = {*definitions["manifest"]["properties"], *definitions["request"]["properties"],
                *definitions["point"]["properties"], *definitions["answer"]["properties"],
                *definitions["answer"]["properties"]["pull_off"]["properties"],
                *(f"can.{key}" for key in definitions["manifest"]["properties"]["can"]["properties"])}
        lacking = sorted(key for key in keys - {"can", "points", "schema"} if key not in named)
        self.tell("every key is on the page", lacking and f"missing: {', '.join(lacking)}")


def main():
    program, root = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        tests = Tests(program, root)
        tests.page_examples()
        tests.manifests()
        request = tests.requests()
        if request:
            tests.answers(request)
        tests.rows_of_page()
        os.chdir("/")
    return tests.end()


sys.exit(main())
