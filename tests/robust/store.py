#!/usr/bin/python3
"""What is stored stays what was solved: campaigns on the results of runs (README.md).

    store.py PROGRAM altered|killed|answered|merged [COUNT [SEED]]

altered   COUNT alterations of stores, records, shards, tables, pins and reference tables. After each, the results that
          the program and the report work with are those of before: what was altered is solved again, written again or
          refused, and a line says so. Prints a table of the alterations by file and kind.
killed    COUNT kills of runs at random moments, sometimes of one of two runs in the same folder. No complete line of a
          store is ever lost or changed, no other file is incomplete, and the run that is continued to its end gives
          what an undisturbed one gives.
answered  COUNT kills of runs of an external solver, each answer of which is a number that no other answer has. The record
          has the first number that was written for each point: it was neither lost nor asked again.
merged    COUNT merges of random numbers of shards in random folders, some killed and continued, some copied or
          concatenated. A merge of all equals one run; a merge in which points are lacking is refused, with the shards.
"""

import collections
import glob
import hashlib
import json
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "reports"))
try:
    from pulloff_report import errors, records
except ImportError:
    records = None    # the report is left out where its Python modules are missing

STORE = "points.jsonl"
CASES = {"mixed": """
scene: {radius: 93, outer_radius: inf, scheme: triangle, nodes: 71}
sweep: [{key: tabor, values: [0, 0.7, 2.385]}]
want: [pull_off, folds, curve, profile, hysteresis, preload]
checks:
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
MANY = """
scene: {outer_radius: inf, scheme: triangle, nodes: 161}
sample: {seed: 7, count: 24, keys: [{key: tabor, from: 0.5, to: 1.5}, {key: radius, from: 70, to: 200}]}
want: [pull_off, folds, curve]
"""
ASK = ["asked", "--solver", "good.yaml"]
VERBS = {"run": [], "verify": [], "explain": [], "bless": ["--reason", "tried"]}
SAID = re.compile(r"altered|checksum|damaged|is not JSON|truncated|not a text file|expected")

# What may differ between two runs with the same results: times, and what depends on them.
TIMES = {"seconds", "seconds_all", "processor_seconds_all", "timing", "checksum", "environment", "processes", "date"}


def results_of(path):
    """What a record contains, but for times and what depends on them."""
    def without_times(value):
        if isinstance(value, dict):
            return {key: without_times(one) for key, one in value.items() if key not in TIMES}
        return [without_times(one) for one in value] if isinstance(value, list) else value
    try:
        return without_times(json.loads(pathlib.Path(path).read_text()))
    except (OSError, ValueError):
        return None


def complete_lines(path):
    """The complete lines of a file, which may be absent."""
    try:
        return pathlib.Path(path).read_bytes().split(b"\n")[:-1]
    except FileNotFoundError:
        return []


def is_intact(line):
    """Whether a line of a store has its checksum (doc/json.md#checksums)."""
    found = re.fullmatch(rb'\{"checksum":"([0-9a-f]{64})",(.*)', line)
    return bool(found) and hashlib.sha256(b"{" + found[2] + b"\n").hexdigest() == found[1].decode()


class Campaign:
    """The program, a folder with a data folder, and what was found wrong."""

    def __init__(self, program, folder, seed):
        self.program, self.folder = str(pathlib.Path(program).resolve()), pathlib.Path(folder)
        self.random, self.faults, self.name = random.Random(seed), [], ""
        self.environment = {**os.environ, "PULLOFF_DATA": str(self.folder / "data"), "OMP_NUM_THREADS": "1"}
        data = self.folder / "data"
        (data / "cases").mkdir(parents=True)
        (data / "reference").mkdir()
        shutil.copy(ROOT / "reference/feng_pull_off.csv", data / "reference")
        (data / "reference/index.txt").write_text("feng_pull_off.csv\n")
        for name, text in {**CASES, "many": MANY}.items():
            (data / "cases" / f"{name}.yaml").write_text(f"name: {name}\ntitle: T\nsuites: [smoke]{text}")
        (self.folder / "good.yaml").write_text(SOLVER.format(here=ROOT / "tests/cli", root=ROOT))

    def start(self, *words, at=None):
        return subprocess.Popen([self.program, *map(str, words)], cwd=at or self.folder, env=self.environment,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def call(self, *words, at=None):
        return subprocess.run([self.program, *map(str, words)], cwd=at or self.folder, env=self.environment,
                              capture_output=True, text=True, check=False)

    def need(self, *words, at=None):
        done = self.call(*words, at=at)
        if done.returncode:
            sys.exit(f"pulloff {' '.join(map(str, words))}: exit code {done.returncode}: {done.stderr}")

    def fail(self, what, done=None):
        self.faults.append(f"{self.name}: {what}" + (f": {done.args[1:]} {done.stderr}" if done else ""))
        return "ACCEPTED"

    def kill(self, process, longest):
        """Ends a process after a random time. Returned: whether it had not ended by itself."""
        time.sleep(self.random.uniform(0, longest))
        process.send_signal(self.random.choice([signal.SIGKILL, signal.SIGKILL, signal.SIGTERM, signal.SIGINT]))
        process.communicate()
        return process.returncode != 0


class Alterations(Campaign):
    def __init__(self, *given):
        """The folder `base`: records and pins, some points, shards, and what a solver has answered."""
        super().__init__(*given)
        self.rows = collections.defaultdict(collections.Counter)
        data, own = self.folder / "data", [name for name in CASES if name != "asked"]
        self.need("bless", *own, "--output", "base/run", "--reason", "first")
        self.need("verify", *own, "--output", "base/run")
        self.need("run", "drawn", "--output", "base/some", "--points", "0-4")
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
        """The files that can be altered, by their place. Of shards only what merge reads."""
        base = self.folder / "base"
        found = collections.defaultdict(list)
        for path in sorted(base.rglob("*.*")):
            place = path.relative_to(base)
            first = place.parts[0]
            kind = {"record.json": "record", "part.json": "part", STORE: "store"}.get(path.name)
            kind = kind or ("shard" if path.name.startswith("shard-") else "table" if path.suffix == ".csv" else None)
            if first in ("pins", "reference"):
                found["pins"].append(place)
            elif first == "shards" and kind in ("store", "shard"):
                found[f"{kind} of a shard"].append(place)
            elif first != "shards" and kind:
                found[f"{kind} of a solver" if first in ("solver", "part") else kind].append(place)
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
        outcome = self.judge(place, is_neutral(path, before))
        self.rows[kind_of_file, name][outcome] += 1
        return True

    def judge(self, place, neutral):
        first, at = place.parts[0], self.folder / "tried"
        if first in ("pins", "reference"):
            return self.judge_data(place, neutral)
        refused = self.is_refused_by_report(place, neutral)
        if first == "shards":
            # the descriptions of two shards of one run differ only in the number and the environment
            neutral = neutral or (place.name != STORE and self.name.endswith("exchanged file"))
            done = self.call("merge", "shards/1", "shards/2", "--output", "run2", at=at)
            if done.returncode:
                return "refused" if SAID.search(done.stderr) else self.fail("refused without a reason", done)
            return self.same(["run2/mixed/record.json", "run2/drawn/record.json"], "run/", neutral, done)
        if first in ("solver", "part"):
            points = ["--points", "0-1"] if first == "part" else []
            done = self.call("verify", *ASK, "--output", first, *points, at=at)
            if place.name == "part.json":    # it is only shown: no later run reads it
                return "refused" if refused or neutral else self.fail("accepted by the report")
            # beside part.json nothing is compared before it is written again
            neutral = neutral or (first == "part" and place.name != STORE)
            return self.same([place.parent / ("part.json" if points else "record.json")], "", neutral, done)
        case = place.parts[1]
        verb = "run" if first == "some" else self.random.choice(sorted(VERBS))
        done = self.call(verb, case, "--output", first, *VERBS[verb], at=at)
        if verb == "bless" and done.returncode == 1 and "is not blessed" in done.stderr:
            return "refused"
        if done.returncode not in (0, 1):
            return self.fail("ended in an error", done)
        outcome = self.same([f"{first}/{case}/record.json"], "run/", neutral, done)
        if outcome == "solved again" and verb == "bless":
            return self.fail("solved again and blessed", done)
        return outcome

    def is_refused_by_report(self, place, neutral):
        if not records or place.name == STORE or place.parts[0] == "shards":
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

    def judge_data(self, place, neutral):
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
        return "refused" if told else "no effect" if neutral else self.fail("accepted by verify", done)

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
            return "written again"
        return "no effect" if may_be_silent else self.fail("nothing is said", done)

    def go(self, count):
        files, done = self.files(), 0
        while done < count:
            kind = self.random.choice(sorted(files))
            done += self.trial(kind, self.random.choice(files[kind]))
        return table(self.rows)


class Kills(Campaign):
    CASE, OUTPUT = ["many"], "run/many"

    def __init__(self, *given):
        super().__init__(*given)
        self.kills = self.kept = 0
        self.prepare()

    def prepare(self):
        begin = time.monotonic()
        self.need("run", *self.CASE, "--output", "whole", "--jobs", 2)
        self.longest = 0.6 * (time.monotonic() - begin)
        self.right = self.tables("whole/many")

    def tables(self, folder):
        return {path.name: path.read_bytes() for path in (self.folder / folder).glob("*.csv")}

    def begin(self):
        return self.start("run", *self.CASE, "--output", "run", "--jobs", self.random.choice([1, 2, 3]))

    def after_kill(self, before):
        """What a run that was killed may leave: a store that has grown; tables only with a record, and whole."""
        lines = complete_lines(self.folder / self.OUTPUT / STORE)
        if not set(before) <= set(lines):
            self.fail("a line of the store is lost")
        if not all(map(is_intact, lines)):
            self.fail("a complete line of the store is not intact")
        if any(self.right.get(name) != content for name, content in self.tables(self.OUTPUT).items()):
            self.fail("a table is torn")
        self.kept += len(lines)

    def compare(self):
        if (self.tables(self.OUTPUT), results_of(self.folder / self.OUTPUT / "record.json")) != \
                (self.right, results_of(self.folder / "whole/many/record.json")):
            self.fail("the results are not those of an undisturbed run")
        if len(complete_lines(self.folder / self.OUTPUT / STORE)) < 24:
            self.fail("the store lacks points")

    def end(self):
        """The run is continued to its end, and a new one is begun."""
        process = self.begin()
        errors_of = process.communicate()[1]
        if process.returncode:
            self.fail(f"the run cannot be continued: {errors_of}")
        self.compare()
        shutil.rmtree(self.folder / "run")

    def go(self, count):
        ends = 0
        while self.kills < count:
            self.name = f"kill {self.kills + 1}"
            before = complete_lines(self.folder / self.OUTPUT / STORE)
            other = self.begin() if self.CASE == ["many"] and self.random.random() < 0.3 else None
            killed = self.kill(self.begin(), self.longest)
            if other and other.communicate() and other.returncode:
                self.fail("a second run in the same folder fails")
            if killed and not other:
                self.kills += 1
                self.after_kill(before)
            if not killed or other or self.random.random() < 0.2:
                self.kills += killed and other is not None
                self.end()
                ends += 1
        self.end()
        if not self.kept:
            self.fail("nothing was stored before a run was killed")
        return f"killed {self.kills} times, {ends + 1} records; {self.kept} lines or answers were written before a kill"


POINTS = 300
STAMPED = """
protocol: pulloff-ask/1
solver: stamped
command: [/usr/bin/python3, '{me}', --answer, '{{request}}', '{{response}}']
can:
  scene: [{{key: tabor}}, {{key: radius}}, {{key: outer_radius}}]
  quantities: [pull_off_force]
  unstable: true
"""
STAMPS = f"""
scene: {{radius: 100, outer_radius: inf, scheme: panel}}
sweep: [{{key: tabor, from: 0.1, to: 3, count: {POINTS}}}]
want: [pull_off]
"""


def answer(request, response):
    """The solver of this campaign: its numbers are the time."""
    points = json.loads(pathlib.Path(request).read_text())["points"]
    with open(response, "w", encoding="utf-8") as stream:
        for point in points:
            time.sleep(random.expovariate(POINTS / 10))
            stamp = float(time.time_ns() % 10**15)
            print(json.dumps({"id": point["id"], "status": "ok", "pull_off": {"force": stamp}}), file=stream, flush=True)


def living(folder):
    """Whether a process works in a folder or below it: a solver, or a child of the program that was killed before it
    became one, which still holds the lock of its folder."""
    for path in glob.glob("/proc/[0-9]*/cwd"):
        try:
            if path != f"/proc/{os.getpid()}/cwd" and os.readlink(path).startswith(f"{folder}/"):
                return True
        except OSError:
            pass
    return False


class Answers(Kills):
    """The number of each point is found in the store by the key of the point, which the first record tells."""

    CASE, OUTPUT = ["stamps", "--solver", "stamped.yaml"], "run/solvers/stamped/stamps"

    def prepare(self):
        self.longest = 1.5
        self.first = {}    # of the present record: the first number that was seen for each point
        (self.folder / "stamped.yaml").write_text(STAMPED.format(me=os.path.abspath(__file__)))
        (self.folder / "data/cases/stamps.yaml").write_text(f"name: stamps\ntitle: T\nsuites: [smoke]{STAMPS}")

    def after_kill(self, before):
        place = self.folder / self.OUTPUT
        while living(str(self.folder)):
            time.sleep(0.01)
        lines = complete_lines(place / STORE)
        if not set(before) <= set(lines):
            self.fail("a line of the store is lost")
        stored = {json.loads(line)["pull_off"]["force"] for line in lines}
        for path in place.glob("ask-*/response.jsonl"):
            found = [json.loads(line) for line in complete_lines(path)]
            self.first.update({one["id"]: one["pull_off"]["force"] for one in found
                               if one["id"] not in self.first and one["pull_off"]["force"] not in stored})
        self.stored = stored
        self.kept += len(lines)

    def compare(self):
        place = self.folder / self.OUTPUT
        final = {point["id"]: point["pull_off"]["force"]
                 for point in json.loads((place / "record.json").read_text())["points"]}
        for point, number in self.first.items():
            if final[point] != number:
                self.fail(f"the answer to point {point} is lost")
        if not getattr(self, "stored", set()) <= set(final.values()):
            self.fail("a stored answer is lost")
        for path in place.glob("ask-*"):
            self.fail(f"left behind: {path}")
        self.kept += len(self.first)
        self.first, self.stored = {}, set()


class Merges(Campaign):
    NAMES = ["mixed", "drawn", "followed"]

    def __init__(self, *given):
        super().__init__(*given)
        begin = time.monotonic()
        self.need("run", *self.NAMES, "--output", "whole")
        self.longest = time.monotonic() - begin

    def shards(self, of):
        """Runs all shards, in folders of their own or shared ones. Returned: the folders."""
        folders = []
        for k in self.random.sample(range(1, of + 1), of):
            folder = self.random.choice(folders) if folders and self.random.random() < 0.3 else f"shards/{k}"
            words = ("run", *self.NAMES, "--shard", f"{k}/{of}", "--output", folder, "--jobs", self.random.choice([1, 2]))
            if self.random.random() < 0.3:
                self.kill(self.start(*words), self.longest / of)
            self.need(*words)
            folders += [folder] if folder not in folders else []
        return folders

    def join(self, folders):
        """Moves the stores of one folder to the end of those of another one."""
        one, other = self.random.sample(folders, 2)
        for path in (self.folder / one).glob(f"*/{STORE}"):
            to = self.folder / other / path.parent.name
            to.mkdir(exist_ok=True)
            with open(to / STORE, "ab") as stream:
                stream.write(path.read_bytes())
            path.unlink()

    def trial(self):
        shutil.rmtree(self.folder / "shards", ignore_errors=True)
        shutil.rmtree(self.folder / "merged", ignore_errors=True)
        of = self.random.randint(1, 5)
        folders = self.shards(of)
        if len(folders) > 1 and self.random.random() < 0.4:
            left = self.random.sample(folders, self.random.randint(1, len(folders) - 1))
            done = self.call("merge", *left, "--output", "merged")
            if done.returncode != 4 or f"/{of}" not in done.stderr.rsplit(": ", 1)[-1] or (self.folder / "merged/mixed").exists():
                self.fail("a merge without all shards is not refused", done)
        if len(folders) > 1 and self.random.random() < 0.3:
            self.join(folders)
        to = self.random.choice(["merged", folders[0]])
        self.need("merge", *self.random.sample(folders, len(folders)), "--output", to)
        for name in self.NAMES:
            if results_of(self.folder / to / name / "record.json") != results_of(self.folder / "whole" / name / "record.json"):
                self.fail(f"the record of {name} is not that of one run")
            for path in (self.folder / "whole" / name).glob("*.csv"):
                if path.read_bytes() != (self.folder / to / name / path.name).read_bytes():
                    self.fail(f"{path.name} of {name} is not that of one run")
        done = self.call("run", *self.NAMES, "--output", to)
        if done.stderr.count("(kept)") != len(self.NAMES):
            self.fail("what was merged is not kept", done)
        return of

    def go(self, count):
        numbers = []
        for k in range(count):
            self.name = f"merge {k + 1}"
            numbers.append(self.trial())
        return f"{count} merges of {sum(numbers)} shards"


def without_checksum(table):
    return [line for line in table.splitlines() if not line.startswith(b"# sha256: ")], table.count(b"# sha256: ")


def is_neutral(path, before):
    """Whether a file still says the same. A store does if every complete line is intact: one of another scene, or none,
    is no altered result."""
    try:
        if path.name == STORE:
            return all(map(is_intact, complete_lines(path)))
        if path.suffix == ".csv":    # the line of the checksum may be anywhere
            return without_checksum(before) == without_checksum(path.read_bytes())
        return json.loads(before) == json.loads(path.read_text())
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


def swap_values(rng, text, pattern=NUMBER):
    one, two = sorted(rng.sample(spans(text, pattern), 2))
    return text[:one[0]] + text[two[0]:two[1]] + text[one[1]:two[0]] + text[one[0]:one[1]] + text[two[1]:]


def swap_keys(rng, text):
    """The keys of two points of a store."""
    return swap_values(rng, text, r'"key":"([0-9a-f]{64})"')


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
            if lines and lines[0].endswith("}"):
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
                              if isinstance(one[key], str) and key in ("digest", "checksum", "curve_sha256", "profile_sha256",
                                                                       "table_sha256", "solve_key", "key")])
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
    name = STORE if path.name == STORE else path.name.split("-")[0] + "-*" + path.suffix
    others = [other for other in path.parents[2].rglob(name) if other != path and other.is_file()]
    if not others:
        return None
    other = rng.choice(sorted(others))
    one, two = path.read_bytes(), other.read_bytes()
    path.write_bytes(two)
    other.write_bytes(one)
    return "exchanged file"


TEXTS = {"digit": digit, "sign": sign, "swapped values": swap_values, "text": change_text, "status, kind": change_status,
         "truncated": lambda rng, text: text[:rng.randrange(len(text))], "swapped lines": of_lines(swap_lines), "exchanged keys": swap_keys,
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


CAMPAIGNS = {"altered": (Alterations, 600), "killed": (Kills, 200), "answered": (Answers, 100), "merged": (Merges, 100)}


def main(program, name, count=None, seed="1"):
    campaign, usual = CAMPAIGNS[name]
    with tempfile.TemporaryDirectory(prefix="pulloff-store-") as folder:
        made = campaign(program, folder, seed)
        print(made.go(int(count or usual)))
    for fault in made.faults:
        print("FAILED:", fault)
    print(f"{name}: {len(made.faults)} failures")
    return bool(made.faults)


if __name__ == "__main__":
    if sys.argv[1] == "--answer":
        answer(*sys.argv[2:])
    else:
        sys.exit(main(*sys.argv[1:]))
