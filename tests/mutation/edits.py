#!/usr/bin/python3
"""Draws random edits of the source, runs the tests with each, and prints the edits that no test noticed.

Works in a copy of the tree with a separate build, below --output. Results are kept there and used again until a file of the
tree changes. README.md says how edits are drawn, and how to judge those that survive."""

import argparse
import collections
import concurrent.futures
import difflib
import hashlib
import itertools
import json
import math
import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import tomllib

import detect
import draw
import plant

SUITES = ("unit", "theory", "convergence", "cases", "cli")
LEFT_OUT = {".git", ".ccache", "__pycache__"}
JUDGED = {"file": str, "function": str, "line": str, "becomes": str, "nth": int, "because": str}
KEY = ("file", "function", "line", "becomes", "nth")
ENOUGH = 95  # per cent of the edits that are not equivalent

# Exit status of a test that lacks a package, see tests/cli/protocol.py: it passes, and catches nothing.
SKIPPED = 77

# Limits of an edited program, which may request any amount: bytes of memory and of one file.
MOST_MEMORY, MOST_FILE = 6 << 30, 256 << 20


def arguments(words):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--seed", type=int, default=1, metavar="N", help="draws other edits (1)")
    parser.add_argument("--count", type=int, default=120, metavar="N", help="how many edits (120)")
    parser.add_argument("--edit", action="append", metavar="NAME", help="only this edit, drawn or not; may be repeated")
    parser.add_argument("--suite", action="append", metavar="NAME",
                        help=f"a suite of tests to run; may be repeated ({', '.join(SUITES)})")
    parser.add_argument("--longest", type=float, default=math.inf, metavar="S", help="only tests that take no more than S seconds")
    parser.add_argument("--output", default=os.path.join("build", "edits"), metavar="DIR",
                        help="where the copy, its build and the results are (build/edits)")
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)), metavar="N", help="edits at a time (all cores)")
    parser.add_argument("--list", action="store_true", help="only print the edits that are drawn")
    return parser.parse_args(words)


# -- The copy of the tree

def stamps_of(root):
    """Size and time of every file of a tree, without builds and the git directory."""
    found = {}
    for place, inner, names in os.walk(root):
        inner[:] = [name for name in inner if name not in LEFT_OUT and not (place == root and name.startswith("build"))]
        for path in (os.path.join(place, name) for name in names):
            state = os.stat(path)
            found[os.path.relpath(path, root)] = (state.st_size, state.st_mtime_ns)
    return found


def mirror(root, copy):
    """Makes a folder a copy of a tree. Equal files are not touched, so that the build does not compile them again."""
    wanted, present = stamps_of(root), stamps_of(copy)
    for name in present.keys() - wanted.keys():
        os.remove(os.path.join(copy, name))
    for name in wanted:
        path, made = os.path.join(root, name), os.path.join(copy, name)
        if name not in present or plant.content(path) != plant.content(made):
            os.makedirs(os.path.dirname(made), exist_ok=True)
            shutil.copy(path, made)


def digest_of(root):
    """sha256 of all files of a tree that a test of an edit may read: not of the judged edits."""
    digest = hashlib.sha256()
    for name in sorted(name for name in stamps_of(root) if not name.startswith("tests/mutation/")):
        digest.update(f"{name}\0{hashlib.sha256(plant.content(os.path.join(root, name))).hexdigest()}\n".encode())
    return digest.hexdigest()


def make_build(tree, folder):
    """Configures and builds the copy; an existing build is updated."""
    setup = [] if os.path.exists(os.path.join(folder, "build.ninja")) else [["meson", "setup", folder, tree]]
    for words in [*setup, ["ninja", "-C", folder]]:
        said = subprocess.run(words, capture_output=True, text=True, check=False)
        if said.returncode:
            raise plant.Stale(f"{' '.join(words)} failed:\n{said.stdout}{said.stderr}")
    return plant.Build(folder, tree)


# -- The list of judged edits

def read_judged(path):
    """The reasons why edits need not be caught, with the keys (file, function, line, becomes, nth)."""
    entries = tomllib.loads(plant.content(path).decode()).get("equivalent", [])
    judged = {}
    for entry in entries:
        entry.setdefault("nth", 1)
        wrong = [key for key in entry if not isinstance(entry[key], JUDGED.get(key, ()))]
        wrong += [key for key in JUDGED if key not in entry]
        key = tuple(entry.get(name) for name in KEY)
        if wrong or key in judged or not entry["because"].strip():
            raise plant.Stale(f"{path}: the entry of {entry.get('file')}, {entry.get('function')}: "
                              f"{', '.join(wrong) or 'twice, or without a reason'}: see tests/mutation/README.md")
        judged[key] = entry["because"]
    return judged


def key_of(edit):
    return tuple(getattr(edit, name) for name in KEY)


def entry_of(edit):
    """The entry of an edit for the list of judged edits, without the reason."""
    lines = ["[[equivalent]]"] + [f"{name} = {json.dumps(getattr(edit, name), ensure_ascii=False)}"
                                  for name in KEY if name != "nth" or edit.nth > 1]
    return "\n".join([*lines, 'because = ""', ""])


# -- The tests

class Tests:
    """The tests of a build, each with the programs that it runs."""

    def __init__(self, build, suites):
        self.build = build
        said = subprocess.run(["meson", "introspect", build.folder, "--tests", "--targets"], capture_output=True,
                              text=True, check=True)
        known = json.loads(said.stdout)
        self.programs = {os.path.relpath(name, build.folder) for target in known["targets"]
                         if target["type"] == "executable" for name in target["filename"]}
        self.folders = {os.path.dirname(name) for name in self.programs}  # a test that is given one reads what is built there
        self.tests = {}
        for test in known["tests"]:
            suite = {word.rpartition(":")[2] for word in test["suite"]}
            programs = {self.program_of(word) for word in test["cmd"]} - {None}
            if suite & set(suites) and programs:
                name = f"{sorted(suite & set(suites))[0]}/{test['name']}"
                self.tests[name] = dict(test, programs=programs, targets={build.tested_by(name) for name in programs})
        if not self.tests:
            raise plant.Stale("no test of these suites runs a program of the build")

    def program_of(self, word):
        """The name of the program of the build that a word of a command refers to; None if there is none."""
        name = os.path.relpath(os.path.join(self.build.folder, word), self.build.folder)
        return name if name in self.programs else None

    def command(self, name, programs, place):
        """The command of a test with other programs instead of those of the build, and its output in `place`."""
        words = []
        for word in self.tests[name]["cmd"]:
            inside = os.path.join(self.build.folder, word)
            if self.program_of(word):
                words.append(programs[self.program_of(word)])
            elif os.path.isabs(word) and inside.startswith(self.build.folder + os.sep) and not os.path.isfile(inside) \
                    and os.pardir not in word.split(os.sep) and os.path.relpath(inside, self.build.folder) not in self.folders:
                words.append(os.path.join(place, os.path.relpath(inside, self.build.folder)))
            else:
                words.append(word)
        return words

    def run(self, name, programs, place, limit):
        """Runs a test. Returns what caught the edit (`test`, `timeout` or None) and the processor time."""
        temporary = tempfile.mkdtemp(prefix="pulloff-edit-")  # not below the tree, which git reads
        environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", TMPDIR=temporary, **self.tests[name]["env"])
        environment["PULLOFF_DATA"] = self.build.source  # scripts set their own
        code, seconds, _ = detect.execute(self.command(name, programs, place),
                                          os.path.join(place, name.replace("/", "-") + ".log"), environment, place, limit)
        shutil.rmtree(temporary, ignore_errors=True)
        return ("timeout" if code is None else "test" if code not in (0, SKIPPED) else None), seconds


# -- The campaign

class Campaign:
    def __init__(self, wanted):
        self.wanted, self.output = wanted, os.path.abspath(wanted.output)
        self.tree = os.path.join(self.output, "tree")
        os.makedirs(self.tree, exist_ok=True)
        mirror(plant.SOURCE, self.tree)
        self.digest, self.stamps = digest_of(self.tree), stamps_of(self.tree)
        self.judged = read_judged(os.path.join(plant.HERE, "equivalents.toml"))
        self.build = make_build(self.tree, os.path.join(self.output, "build"))
        self.tests = Tests(self.build, wanted.suite or SUITES)
        self.lock = threading.Lock()

    def place(self, *names):
        path = os.path.join(self.output, "work", *names)
        shutil.rmtree(path, ignore_errors=True)
        os.makedirs(path)
        return path

    def kept(self, name, work):
        """A result of an earlier run with the same tree, or of `work`, which is then kept."""
        path = os.path.join(self.output, "results", name + ".json")
        try:
            found = json.loads(plant.content(path))
        except (OSError, ValueError):
            found = {}
        if found.get("digest") != self.digest:
            found = {"digest": self.digest, "value": work()}
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "w", encoding="utf-8") as stream:
                json.dump(found, stream)
        return found["value"]

    def draw(self):
        """The selected edits."""
        edits, self.paths = draw.candidates(self.tree)
        named = {edit.name: edit for edit in edits}
        for file, function, line, becomes, _ in sorted(self.judged.keys() - {key_of(edit) for edit in edits}):
            print(f"# {file}, {function}: no longer in the source, take it from equivalents.toml: {line} -> {becomes}")
        if self.wanted.edit:
            unknown = set(self.wanted.edit) - named.keys()
            if unknown:
                raise plant.Stale(f"there is no edit {', '.join(sorted(unknown))} of this source")
            return [named[name] for name in self.wanted.edit]

        def drawn():
            compiler = draw.Compiler(self.build, self.place("draw"), self.paths)
            effective = filter(compiler.is_effective, draw.order(self.wanted.seed, edits))
            return [edit.name for edit in itertools.islice(effective, self.wanted.count)]
        return [named[name] for name in self.kept(f"drawn-{self.wanted.seed}-{self.wanted.count}", drawn)]

    def run_baseline(self):
        """The processor time of every test without an edit. No test may fail then."""
        def one(name):
            programs = {program: os.path.join(self.build.folder, program) for program in self.tests.tests[name]["programs"]}
            place = self.place("baseline", name)
            for _ in range(2):  # a second time, because a test may time out once on a loaded machine
                by, seconds = self.tests.run(name, programs, place, detect.FIRST_LIMIT)
                if not by:
                    return seconds
            raise plant.Stale(f"{name} fails without an edit: see {place}")
        names = sorted(self.tests.tests)
        with concurrent.futures.ThreadPoolExecutor(self.wanted.jobs) as pool:
            seconds = pool.map(lambda name: self.kept(f"baseline/{name}", lambda: one(name)), names)
        self.baseline = {name: time for name, time in zip(names, seconds) if time <= self.wanted.longest}

    def source_of(self, edit):
        return plant.content(self.paths[edit.file]).decode()

    def diff(self, edit):
        source, name = self.source_of(edit), os.path.relpath(self.paths[edit.file], self.tree)
        return "".join(difflib.unified_diff(source.splitlines(True), edit.applied(source).splitlines(True),
                                            "a/" + name, "b/" + name, n=2))

    def try_edit(self, edit):
        """What catches an edit: the name of the test and how. First the tests of its library, then the others, the
        quickest first."""
        place, programs = self.place(edit.name), {}
        made = [self.build.compile_text(self.paths[edit.file], edit.applied(self.source_of(edit)), place, ["-w"])]
        target = self.build.target_of(self.paths[edit.file])
        for name in sorted(self.baseline, key=lambda name: (target not in self.tests.tests[name]["targets"], self.baseline[name])):
            altered = self.altered(name, programs, made, place)
            if not altered:
                continue
            limit = detect.limit_of(self.baseline[name])
            by, _ = self.tests.run(name, altered, place, limit)
            if by and self.tests.tests[name]["cmd"][0] not in altered.values():
                by, _ = self.tests.run(name, altered, place, limit)  # a script may time out once, so it must fail twice
            if by or not self.is_restored():
                shutil.rmtree(place)
                return [name, by or "tree"]
        return None

    def altered(self, name, programs, made, place):
        """The programs of a test, linked with the edit where they contain the edited file; none if no program does."""
        for program in self.tests.tests[name]["programs"]:
            if program not in programs:
                programs[program] = self.build.program(program, made, place)
        own = {program: programs[program] for program in self.tests.tests[name]["programs"]}
        return {program: path or os.path.join(self.build.folder, program) for program, path in own.items()} if any(own.values()) else None

    def is_restored(self):
        """Whether no program has written into the copy of the tree, which is restored otherwise."""
        with self.lock:
            same = stamps_of(self.tree) == self.stamps
            if not same:
                mirror(plant.SOURCE, self.tree)
                self.stamps = stamps_of(self.tree)
            return same

    def run(self, edits):
        """The edits, each with what caught it."""
        def outcome(edit):
            by = self.kept(f"{edit.name}-{self.wanted.longest}", lambda: self.try_edit(edit))
            print(f"{edit.name}, {edit.file}: {f'caught by {by[0]}' if by else 'not caught'}", file=sys.stderr, flush=True)
            return edit, by
        with concurrent.futures.ThreadPoolExecutor(self.wanted.jobs) as pool:
            return list(pool.map(outcome, edits))


def summary(campaign, results):
    """Prints the edits that survive and the counts. Returns whether enough edits were caught."""
    caught = [(edit, by) for edit, by in results if by]
    left = [edit for edit, by in results if not by]
    judged = [edit for edit in left if key_of(edit) in campaign.judged]
    survivors = [edit for edit in left if edit not in judged]
    for edit in judged + survivors:
        print(f"# {edit.name}, {edit.kind}: {campaign.judged.get(key_of(edit), 'survives')}\n{campaign.diff(edit)}")
    path = os.path.join(campaign.output, "survivors.toml")
    with open(path, "w", encoding="utf-8") as stream:
        stream.write("\n".join(map(entry_of, survivors)))
    for what, of in (("test", lambda edit, by: by[0]), ("kind of edit", lambda edit, by: edit.kind),
                     ("file", lambda edit, by: edit.file)):
        counts = collections.Counter(of(*row) for row in caught)
        print(f"# caught, by {what}: " + ", ".join(f"{name} {count}" for name, count in counts.most_common()))
    late = sum(by[1] == "timeout" for _, by in caught)
    share = 100.0 * len(caught) / max(1, len(results) - len(judged))
    print(f"# {len(results)} drawn, {len(caught)} caught ({late} of them out of time), {len(judged)} equivalent, "
          f"{len(survivors)} survivors (entries for equivalents.toml, without reasons: {path}); {share:.1f} % of those that are "
          "not equivalent are caught")
    return share >= ENOUGH


def interrupted(*_):
    """Ends the campaign. Finished results are kept, the running ones are lost."""
    detect.stop_all()
    os._exit(130)


def main(words):
    wanted = arguments(words)
    for limit, most in ((resource.RLIMIT_AS, MOST_MEMORY), (resource.RLIMIT_FSIZE, MOST_FILE)):
        resource.setrlimit(limit, (most, resource.RLIM_INFINITY))
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, interrupted)
    try:
        campaign = Campaign(wanted)
        edits = campaign.draw()
        if wanted.list:
            for edit in edits:
                print(f"# {edit.name}, {edit.kind}, in {edit.function or 'no function'}\n{campaign.diff(edit)}")
            return 0
        campaign.run_baseline()
        return 0 if summary(campaign, campaign.run(edits)) else 1
    except (plant.Stale, OSError, ValueError) as error:
        print(f"Bail out! {error}")
        return 4


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
