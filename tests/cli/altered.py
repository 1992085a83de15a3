#!/usr/bin/python3
"""Alters stored results at random and tests that none is accepted: altered.py PROGRAM [COUNT [SEED]]

COUNT alterations (default 600) of records, journals, shards, tables beside them, pins and reference tables. After each,
the results that the program and the report work with must be those of before: what was altered is solved again or
refused, and a line says so. Prints a table of the alterations by file and kind.
"""

import collections
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "reports"))
try:
    from pulloff_report import errors, records
except ImportError:
    records = None    # the report is left out where its Python modules are missing

CASES = {"mixed": """
scene: {radius: 93, outer_radius: inf, scheme: triangle, nodes: 71}
sweep: [{key: tabor, values: [0, 0.7, 2.385]}]
want: [pull_off, folds, curve, profile, hysteresis, preload]
checks:
  - {quantity: pull_off_force, reference: pin, tolerance: 1e-9, kind: rel, because: b}
  - {quantity: folds, reference: pin, tolerance: 1e-6, kind: abs, because: b}
  - {quantity: work, reference: pin, tolerance: 0.5, kind: rel, because: b}
  - {quantity: pull_off_force, reference: reference/feng_pull_off.csv, tolerance: 0.3, kind: abs, because: b,
     as_if: [{key: tabor, values: [2]}], when: [{key: tabor, values: [2.385]}]}
lines:
  - {name: crest, theory: bradley, sweep: [{key: approach, from: -3, to: 0.5, count: 9}]}
""", "followed": """
scene: {radius: 93, outer_radius: 80, scheme: panel, tolerance: 1e-4, wavelength: 21, amplitude: 0.21}
sweep: [{key: tabor, from: 0.5, to: 0.6, count: 3, scale: log}]
follow: tabor
traced: {seed: 7, count: 1}
want: [pull_off]
checks: [{quantity: pull_off_force, reference: traced, tolerance: 1e-3, kind: rel, because: b}]
""", "drawn": """
scene: {outer_radius: inf, scheme: triangle, nodes: 61}
sample: {seed: 5, count: 7, keys: [{key: tabor, from: 0.7, to: 1.3}, {key: radius, from: 70, to: 200}]}
repeats: 2
want: [pull_off, curve]
""", "asked": """
scene: {radius: 100, outer_radius: inf, scheme: panel}
sweep: [{key: tabor, values: [0.5, 1, 2, 3]}]
want: [pull_off]
checks: [{quantity: pull_off_force, reference: reference/feng_pull_off.csv, tolerance: 1e-2, kind: abs, because: b}]
"""}
SOLVER = """protocol: pulloff-ask/1
solver: good
command: [/usr/bin/python3, '{here}/responder.py', good, '{root}/reference/feng_pull_off.csv', '{{request}}', '{{response}}']
can: {{scene: [{{key: tabor, to: 5}}, {{key: radius}}, {{key: outer_radius}}],
  quantities: [pull_off_force, pull_off_approach, contact_radius], unstable: true}}
"""
ASK = ["asked", "--solver", "good.yaml"]
VERBS = {"run": [], "verify": [], "explain": [], "bless": ["--reason", "tried"]}
SAID = re.compile(r"altered|checksum|damaged|is not JSON|truncated|not a text file|expected")

# What may differ between two runs with the same results: times, and what depends on them.
TIMES = {"seconds", "seconds_all", "processor_seconds_all", "timing", "checksum", "environment", "processes", "date"}


class Trials:
    def __init__(self, program, folder, seed):
        self.program, self.folder = str(pathlib.Path(program).resolve()), pathlib.Path(folder)
        self.random = random.Random(seed)
        self.rows, self.faults = collections.defaultdict(collections.Counter), []
        self.environment = {**os.environ, "PULLOFF_DATA": str(self.folder / "data"), "OMP_NUM_THREADS": "1"}

    def call(self, *words, at=None):
        return subprocess.run([self.program, *map(str, words)], cwd=at or self.folder, env=self.environment,
                              capture_output=True, text=True, check=False)

    def need(self, *words):
        done = self.call(*words)
        if done.returncode:
            sys.exit(f"pulloff {' '.join(words)}: exit code {done.returncode}: {done.stderr}")

    def prepare(self):
        """The folder `base`: records and pins, a journal, the shards, and what a solver has answered."""
        data = self.folder / "data"
        (data / "cases").mkdir(parents=True)
        (data / "reference").mkdir()
        shutil.copy(ROOT / "reference/feng_pull_off.csv", data / "reference")
        (data / "reference/index.txt").write_text("feng_pull_off.csv\n")
        for name, text in CASES.items():
            (data / "cases" / f"{name}.yaml").write_text(f"name: {name}\ntitle: T\nsuites: [smoke]{text}")
        (self.folder / "good.yaml").write_text(SOLVER.format(here=ROOT / "tests/cli", root=ROOT))
        own = [name for name in CASES if name != "asked"]
        self.need("bless", *own, "--output", "base/run", "--reason", "first")
        self.need("verify", *own, "--output", "base/run")
        self.need("run", "drawn", "--output", "base/journal", "--points", "0-4")
        for k in (1, 2):
            self.need("run", "mixed", "drawn", "--output", f"base/shards/{k}", "--shard", f"{k}/2")
        self.need("verify", *ASK, "--output", "base/solver")
        self.need("verify", *ASK, "--output", "base/part", "--points", "0-1")
        shutil.copytree(data / "cases/pins", self.folder / "base/pins")
        shutil.copytree(data / "reference", self.folder / "base/reference")
        shutil.copy(self.folder / "good.yaml", self.folder / "base")
        self.results = {path.relative_to(self.folder / "base"): results_of(path)
                        for path in (self.folder / "base").rglob("*.json") if path.name in ("record.json", "part.json")}

    def files(self):
        """The files that can be altered, by their place."""
        base = self.folder / "base"
        found = collections.defaultdict(list)
        for path in sorted(base.rglob("*")):
            place = path.relative_to(base)
            if path.is_file():
                kind = {"record.json": "record", "part.json": "part", "points.jsonl": "journal"}.get(path.name)
                kind = kind or ("shard" if path.name.startswith("shard-") else "table" if path.suffix == ".csv" else None)
                if kind and place.parts[0] in ("pins", "reference"):
                    kind = "pins"
                if kind:
                    found[f"{kind} of a {'solver' if place.parts[0] in ('solver', 'part') else 'shard'}"
                          if place.parts[0] in ("solver", "part", "shards") and kind not in ("shard", "part") else kind].append(place)
        return found

    def trial(self, kind_of_file, place):
        """One alteration of one file."""
        shutil.rmtree(self.folder / "tried", ignore_errors=True)
        shutil.copytree(self.folder / "base", self.folder / "tried")
        path = self.folder / "tried" / place
        before = path.read_bytes()
        name = alter(self.random, path)
        if name is None or path.read_bytes() == before:
            return False
        self.name = f"{place}: {name}"
        neutral = is_neutral(path, before)
        outcome = self.judge(place, neutral)
        self.rows[kind_of_file, name][outcome] += 1
        return True

    def fail(self, what, done=None):
        self.faults.append(f"{self.name}: {what}" + (f": {done.args[1:]} {done.stderr}" if done else ""))
        return "ACCEPTED"

    def judge(self, place, neutral):
        first = place.parts[0]
        if first in ("pins", "reference"):
            return self.judge_data(place)
        refused = self.is_refused_by_report(place, neutral)
        # a line of another scene, or the last one if it is incomplete, is none of an altered result
        neutral = neutral or place.name == "points.jsonl"
        if first == "shards":
            done = self.call("merge", "shards/1", "shards/2", "--output", "run2", at=self.folder / "tried")
            if done.returncode:
                return "refused" if SAID.search(done.stderr) else self.fail("refused without a reason", done)
            return self.same(["run2/mixed/record.json", "run2/drawn/record.json"], "run/", neutral, done)
        if first in ("solver", "part"):
            points = ["--points", "0-1"] if first == "part" else []
            done = self.call("verify", "asked", "--solver", "good.yaml", "--output", first, *points, at=self.folder / "tried")
            if place.name == "part.json":    # it is only shown: no later run reads it
                return "refused" if refused or neutral else self.fail("accepted by the report")
            return self.same([place.parent / ("part.json" if points else "record.json")], "", neutral, done)
        case = place.parts[1]
        verb = "run" if first == "journal" else self.random.choice(sorted(VERBS))
        done = self.call(verb, case, "--output", first, *VERBS[verb], at=self.folder / "tried")
        if verb == "bless" and done.returncode == 1 and "is not blessed" in done.stderr:
            return "refused"
        if done.returncode not in (0, 1):
            return self.fail("ended in an error", done)
        outcome = self.same([f"{first}/{case}/record.json"], "run/", neutral, done)
        if outcome == "solved again" and verb == "bless":
            return self.fail("solved again and blessed", done)
        pins = {path.name: path.read_text() for path in (self.folder / "data/cases/pins").iterdir()}
        if pins != {path.name: path.read_text() for path in (self.folder / "base/pins").iterdir()}:
            return self.fail("the pins have changed", done)
        return outcome

    def is_refused_by_report(self, place, neutral):
        """Whether the report refuses the altered records of a run; it must."""
        if not records or place.name not in ("record.json", "part.json") and place.suffix != ".csv" or place.parts[0] in (
                "journal", "shards"):
            return False
        try:
            case = records.Case(str((self.folder / "tried" / place).parent))
            for point in case.points:
                case.curve(point)
                case.profile(point)
            for name in case._lines:    # pylint: disable=protected-access
                case.line(name)
        except errors.ReportError:
            return True
        if not neutral:
            self.fail("accepted by the report")
        return False

    def judge_data(self, place):
        """Pins, stored digests and reference tables: verify must name the file."""
        at = self.folder / "data" / ("cases" if place.parts[0] == "pins" else "") / place
        before = at.read_bytes()
        shutil.copy(self.folder / "tried" / place, at)
        try:
            name = "followed" if "followed" in place.name else "drawn" if "drawn" in place.name else "mixed"
            done = self.call("verify", name, "--output", "run", at=self.folder / "tried")
        finally:
            at.write_bytes(before)
        told = done.returncode and place.name in done.stderr + done.stdout
        return "refused" if told else self.fail("accepted by verify", done)

    def same(self, places, base, may_be_silent, done):
        """Whether records have the results of before, and a line says that something was altered."""
        for place in places:
            place = pathlib.Path(place)
            original = place if not base else pathlib.Path(base, *place.parts[1:])
            if results_of(self.folder / "tried" / place) != self.results[original]:
                return self.fail(f"{place} has other results", done)
        if "solved again" in done.stderr:
            return "solved again"
        if "was altered" in done.stderr:
            return "results kept"
        return "no effect" if may_be_silent else self.fail("nothing is said", done)


def results_of(path):
    """What a record contains, but for times and what depends on them."""
    def without_times(value):
        if isinstance(value, dict):
            return {key: without_times(one) for key, one in value.items() if key not in TIMES}
        return [without_times(one) for one in value] if isinstance(value, list) else value
    try:
        return without_times(json.loads(path.read_text()))
    except (OSError, ValueError):
        return None


def is_neutral(path, before):
    """Whether a file still says the same."""
    try:
        old, new = ([json.loads(line) for line in text.splitlines()] if path.suffix == ".jsonl" else json.loads(text)
                    for text in (before.decode(), path.read_text()))
        return old == new
    except ValueError:
        return False


def spans(text, pattern):
    return [match.span(1) for match in re.finditer(pattern, text)]


NUMBER = r"(-?[0-9]+\.[0-9]+(?:[eE][-+]?[0-9]+)?|\b[0-9]+\b)"


def replace(text, span, new):
    return text[:span[0]] + new + text[span[1]:]


def digit(rng, text):
    place = rng.choice(spans(text, r"([0-9])"))
    return replace(text, place, rng.choice([c for c in "0123456789" if c != text[place[0]]]))


def sign(rng, text):
    place = rng.choice(spans(text, NUMBER))
    return replace(text, place, text[place[0]:place[1]][1:] if text[place[0]] == "-" else "-" + text[place[0]:place[1]])


def swap_values(rng, text):
    one, two = sorted(rng.sample(spans(text, NUMBER), 2))
    return text[:one[0]] + text[two[0]:two[1]] + text[one[1]:two[0]] + text[one[0]:one[1]] + text[two[1]:]


def of_lines(edit):
    def apply(rng, text):
        lines = text.splitlines(keepends=True)
        edit(lines, *(rng.sample(range(len(lines)), 2)))
        return "".join(lines)
    return apply


def swap_lines(lines, one, two):
    lines[one], lines[two] = lines[two], lines[one]


def change_text(rng, text):
    found = [span for span in spans(text, r'"([A-Za-z_][^"\\]*)"') or spans(text, r"([A-Za-z_]{3,})")]
    place = rng.choice(found)
    at = rng.randrange(*place)
    return replace(text, (at, at + 1), rng.choice([c for c in "abcdefxyz_" if c != text[at]]))


def change_status(rng, text):
    words = ["ok", "not_converged", "jump_in", "jump_out", "minimum", "maximum", "within", "outside", "true", "false", "null"]
    found = spans(text, r"\b(" + "|".join(words) + r")\b")
    if not found:
        return None
    place = rng.choice(found)
    return replace(text, place, rng.choice([word for word in words if word != text[place[0]:place[1]]]))


def of_json(edit):
    """An alteration of the parsed document, or of a line of a journal."""
    def apply(rng, text):
        lines = text.splitlines()
        try:
            if len(lines) > 1 and lines[0].endswith("}"):
                place = rng.randrange(len(lines))
                document = json.loads(lines[place])
                edit(rng, document)
                return "\n".join(lines[:place] + [json.dumps(document, separators=(",", ":"))] + lines[place + 1:]) + "\n"
            document = json.loads(text)
            edit(rng, document)
            return json.dumps(document, indent=2) + "\n"
        except (ValueError, LookupError):
            return None
    return apply


def walk(value):
    yield value
    for inner in value.values() if isinstance(value, dict) else value if isinstance(value, list) else ():
        yield from walk(inner)


def drop(kind):
    def apply(rng, document):
        holder = rng.choice([one for one in walk(document) if isinstance(one, kind) and one])
        del holder[rng.choice(sorted(holder) if kind is dict else range(len(holder)))]
    return apply


def factor(rng, document):
    holder, key = rng.choice([(one, key) for one in walk(document) if isinstance(one, dict)
                              for key, value in sorted(one.items()) if isinstance(value, float) and value])
    holder[key] *= 1 + rng.choice([-1, 1]) * 10 ** rng.uniform(-15, -1)


def digest(rng, document):
    holder, key = rng.choice([(one, key) for one in walk(document) if isinstance(one, dict) for key in sorted(one)
                              if key in ("digest", "checksum", "curve_sha256", "profile_sha256", "table_sha256", "solve_key", "key")])
    holder[key] = digit(rng, holder[key])


def exchange_points(rng, document):
    """The results of two points, each with the id of the other."""
    points = document["points"]
    one, two = rng.sample(range(len(points)), 2)
    kept = ("id", "label", "sweep", "input")
    first, second = ({key: points[k][key] for key in kept} for k in (one, two))
    points[one], points[two] = {**points[two], **first}, {**points[one], **second}


def exchange_files(rng, path):
    """With the same file of another point, case or shard."""
    head = path.name.split("-")[0]
    others = [other for other in path.parents[2].rglob(f"{head}*{path.suffix}") if other != path and other.is_file()]
    if not others:
        return None
    other = rng.choice(sorted(others))
    one, two = path.read_bytes(), other.read_bytes()
    path.write_bytes(two)
    other.write_bytes(one)
    return "exchanged file"


TEXTS = {"digit": digit, "sign": sign, "swapped values": swap_values, "text": change_text, "status, kind": change_status,
         "truncated": lambda rng, text: text[:rng.randrange(len(text))], "swapped lines": of_lines(swap_lines),
         "dropped line": of_lines(lambda lines, one, two: lines.pop(one)),
         "doubled line": of_lines(lambda lines, one, two: lines.insert(one, lines[one]))}
DOCUMENTS = {"dropped key": of_json(drop(dict)), "dropped item": of_json(drop(list)), "factor near 1": of_json(factor),
             "digest": of_json(digest), "exchanged points": of_json(exchange_points)}


def alter(rng, path):
    """Alters a file. Returned: the kind of the alteration; None if it does not apply."""
    kinds = {**TEXTS, **(DOCUMENTS if path.suffix.startswith(".json") else {})}
    name = rng.choice([*kinds, "exchanged file"])
    if name == "exchanged file":
        return exchange_files(rng, path)
    try:
        text = kinds[name](rng, path.read_text())
    except (IndexError, ValueError):
        return None
    if text is None:
        return None
    path.write_text(text)
    return name


def table(rows):
    outcomes = sorted({outcome for row in rows.values() for outcome in row})
    lines = [("file", "alteration", *outcomes)]
    lines += [(*key, *(str(row[outcome] or "") for outcome in outcomes)) for key, row in sorted(rows.items())]
    total = sum(rows.values(), collections.Counter())
    lines.append(("all", "", *(str(total[outcome]) for outcome in outcomes)))
    widths = [max(map(len, column)) for column in zip(*lines)]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip() for line in lines)


def main():
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 600
    with tempfile.TemporaryDirectory(prefix="pulloff-altered-") as folder:
        trials = Trials(sys.argv[1], folder, sys.argv[3] if len(sys.argv) > 3 else "1")
        trials.prepare()
        files, done = trials.files(), 0
        while done < count:
            kind = trials.random.choice(sorted(files))
            done += trials.trial(kind, trials.random.choice(files[kind]))
        print(table(trials.rows))
        for fault in trials.faults:
            print("FAILED:", fault)
    print(f"{count} alterations, {len(trials.faults)} failures")
    return bool(trials.faults)


sys.exit(main())
