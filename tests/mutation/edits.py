#!/usr/bin/python3
"""Draws random edits of the source, runs the tests with each, and prints the edits that no test noticed.

Works in a copy of the tree with a separate build, below --output. Results are kept there and used again until the
sources or tests change. README.md says how edits are drawn, and how to judge those that survive."""

import argparse
import collections
import concurrent.futures
import difflib
import fcntl
import hashlib
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
import time
import tomllib

import detect
import draw
import plant

SUITES = ("unit", "theory", "convergence", "cases", "cli")
LEFT_OUT = {".git", ".ccache", "__pycache__"}
NO_PART = ("tests/mutation/", "tests/report/", "reports/")  # parts of the copy that no test of an edit reads
JUDGED = {"file": str, "function": str, "line": str, "becomes": str, "nth": int, "because": str}
KEY = ("file", "function", "line", "becomes", "nth")
ENOUGH = 95  # per cent of the edits that are not equivalent

# The initial order of the tests assumes that each test was run PRIOR times and caught one edit, or PRIOR_OWN edits of
# the library that it is a test of.
PRIOR, PRIOR_OWN = 10, 6

# Exit status of a test that lacks a package, see tests/cli/adapters.sh: it passes, and catches nothing.
SKIPPED = 77

# Approximate time to link a program, in seconds.
LINK = 0.2

# Limits of an edited program, which may request any amount: bytes of memory and of one file.
MOST_MEMORY, MOST_FILE = 6 << 30, 256 << 20


def arguments(words):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--seed", type=int, default=1, metavar="N", help="draws other edits (1)")
    parser.add_argument("--count", type=int, default=120, metavar="N", help="how many edits (120)")
    parser.add_argument("--edit", action="append", metavar="NAME", help="only this edit, drawn or not; may be repeated")
    parser.add_argument("--suite", action="append", metavar="NAME",
                        help=f"a suite of tests to run; may be repeated ({', '.join(SUITES)})")
    parser.add_argument("--longest", type=float, default=math.inf, metavar="S",
                        help="only tests that take no more than S seconds; a later run takes up the others")
    parser.add_argument("--output", default=os.path.join("build", "edits"), metavar="DIR",
                        help="where the copy, its build and the results are (build/edits)")
    parser.add_argument("--jobs", type=int, default=0, metavar="N", help="edits at a time (0: all cores)")
    parser.add_argument("--sanitize", action="store_true",
                        help="run the tests under the address and undefined-behaviour sanitizers, several times slower")
    parser.add_argument("--list", action="store_true", help="only print the edits that are drawn")
    parser.add_argument("--fresh", action="store_true", help="keep no results of earlier runs")
    return parser.parse_args(words)


# -- The copy of the tree

def files_below(root):
    """All files of a tree, relative to it, without builds and the git directory."""
    for place, inner, names in os.walk(root):
        at_root = os.path.samefile(place, root)
        inner[:] = sorted(name for name in inner if name not in LEFT_OUT and not (at_root and name.startswith("build")))
        for name in sorted(names):
            yield os.path.relpath(os.path.join(place, name), root)


def content(path):
    with open(path, "rb") as stream:
        return stream.read()


def mirror(root, copy):
    """Makes a folder a copy of a tree. Equal files are not touched, so that the build does not compile them again."""
    wanted = set(files_below(root))
    if os.path.isdir(copy):
        for name in set(files_below(copy)) - wanted:
            os.remove(os.path.join(copy, name))
    for name in wanted:
        path, made = os.path.join(root, name), os.path.join(copy, name)
        if not os.path.exists(made) or content(path) != content(made):
            os.makedirs(os.path.dirname(made), exist_ok=True)
            shutil.copy(path, made)


def digest_of(root, below=("",)):
    """sha256 of all files that a result depends on, or only of those below the given folders."""
    digest = hashlib.sha256()
    for name in files_below(root):
        if name.startswith(below) and not name.startswith(NO_PART):
            digest.update(f"{name}\0{hashlib.sha256(content(os.path.join(root, name))).hexdigest()}\n".encode())
    return digest.hexdigest()


def stamps_of(root):
    """Size and time of every file, to detect whether a test wrote into the tree."""
    found = {}
    for name in files_below(root):
        state = os.stat(os.path.join(root, name))
        found[name] = (state.st_size, state.st_mtime_ns)
    return found


def make_build(tree, folder, options):
    """Configures and builds the copy; an existing build is updated."""
    setup = [] if os.path.exists(os.path.join(folder, "build.ninja")) else [["meson", "setup", folder, tree, *options]]
    for words in [*setup, ["ninja", "-C", folder]]:
        said = subprocess.run(words, capture_output=True, text=True, check=False)
        if said.returncode:
            raise plant.Stale(f"{' '.join(words)} failed:\n{said.stdout}{said.stderr}")


# -- The list of judged edits

def read_judged(path):
    """The reasons why edits need not be caught, with the keys (file, function, line, becomes, nth)."""
    with open(path, "rb") as stream:
        entries = tomllib.load(stream).get("equivalent", [])
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
                self.tests[name] = dict(test, programs=programs, targets={self.build.tested_by(name) for name in programs})

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
                words.append(inside if os.sep in word and os.path.exists(inside) else word)
        return words

    def run(self, name, programs, place, limit):
        """Runs a test. Returns what caught the edit (`test`, `timeout` or None) and the processor time."""
        temporary = tempfile.mkdtemp(prefix="pulloff-edit-")  # not below the tree, which git reads
        environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", TMPDIR=temporary,
                           UBSAN_OPTIONS="halt_on_error=1", ASAN_OPTIONS="intercept_tls_get_addr=0",
                           **self.tests[name]["env"])
        environment["PULLOFF_DATA"] = self.build.source  # scripts set their own
        code, seconds, _ = detect.execute(self.command(name, programs, place),
                                          os.path.join(place, name.replace("/", "-") + ".log"), environment, place,
                                          limit)
        shutil.rmtree(temporary, ignore_errors=True)
        return ("timeout" if code is None else "test" if code not in (0, SKIPPED) else None), seconds


def expected_cost(seconds, tried, caught, own=False):
    """Expected processor time of a test for each edit that it catches. It determines the order of the tests. `own`: the
    test is one of the library that the edit is in."""
    return (seconds + LINK) * (tried + PRIOR) / (caught + (PRIOR_OWN if own else 1))


# -- The campaign

class Campaign:
    def __init__(self, wanted):
        self.wanted = wanted
        self.output = os.path.abspath(wanted.output)
        self.jobs = wanted.jobs or len(os.sched_getaffinity(0))
        self.tree = os.path.join(self.output, "tree")
        os.makedirs(self.output, exist_ok=True)
        self.hold = open(os.path.join(self.output, "lock"), "w", encoding="utf-8")
        try:
            fcntl.flock(self.hold, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise plant.Stale(f"another run works in {self.output}: expected one with --output of its own") from error
        self.whole = os.path.join(self.output, "whole")  # from which the copy is restored if an edit wrote into it
        mirror(plant.SOURCE, self.whole)
        mirror(self.whole, self.tree)
        self.digest = digest_of(self.tree)
        self.stamps = stamps_of(self.tree)
        self.judged = read_judged(os.path.join(plant.HERE, "equivalents.toml"))
        self.build = self.built("build", [])
        self.tested = self.built("build-sanitize", ["-Dbuildtype=debugoptimized", "-Db_sanitize=address,undefined"]) \
            if wanted.sanitize else self.build
        self.tests = Tests(self.tested, wanted.suite or SUITES)
        if not self.tests.tests:
            raise plant.Stale("no test of these suites runs a program of the build")
        self.baseline, self.asked = {}, set()
        self.results = os.path.join(self.output, "results-sanitize" if wanted.sanitize else "results")
        os.makedirs(self.results, exist_ok=True)
        self.history = self.read_history()
        self.lock = threading.Lock()
        self.total, self.done, self.begin = 0, 0, time.monotonic()

    def built(self, name, options):
        make_build(self.tree, os.path.join(self.output, name), options)
        return plant.Build(os.path.join(self.output, name), self.tree)

    def place(self, *names):
        path = os.path.join(self.output, "work", *names)
        shutil.rmtree(path, ignore_errors=True)
        os.makedirs(path)
        return path

    def kept(self, path):
        try:
            with open(path, encoding="utf-8") as stream:
                return json.load(stream)
        except (OSError, ValueError):
            return {}

    def keep(self, path, value):
        with open(path + ".new", "w", encoding="utf-8") as stream:
            json.dump(value, stream, indent=1)
            stream.write("\n")
        os.replace(path + ".new", path)

    def run_baseline(self):
        """The processor time of every test without an edit. No test may fail then."""
        path = os.path.join(self.results, "..", os.path.basename(self.results) + "-baseline.json")
        kept = self.kept(path)
        known = kept.get("seconds", {}) if kept.get("digest") == self.digest else {}

        def one(name):
            if name in known:
                return known[name]
            programs = {program: os.path.join(self.tested.folder, program)
                        for program in self.tests.tests[name]["programs"]}
            place = self.place("baseline", name)
            for _ in range(2):  # a second time, because a test may time out once on a loaded machine
                by, seconds = self.tests.run(name, programs, place, detect.FIRST_LIMIT * (10 if self.wanted.sanitize
                                                                                         else 1))
                if not by:
                    return seconds
            raise plant.Stale(f"{name} fails without an edit: see {place}")
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            self.baseline = dict(zip(self.tests.tests, pool.map(one, self.tests.tests)))
        self.keep(path, {"digest": self.digest, "seconds": self.baseline})
        self.asked = {name for name, seconds in self.baseline.items() if seconds <= self.wanted.longest}

    def draw(self):
        """The selected edits. Keeps which candidates change the program, because finding out needs a compilation."""
        modules = draw.candidates(self.tree)
        edits = {edit.name: edit for found in modules.values() for edit in found}
        known = {key_of(edit) for edit in edits.values()}
        for file, function, line, becomes, _ in sorted(self.judged.keys() - known):
            print(f"# {file}, {function}: no longer in the source, take it from equivalents.toml: {line} -> {becomes}")
        if self.wanted.edit:
            unknown = set(self.wanted.edit) - edits.keys()
            if unknown:
                raise plant.Stale(f"there is no edit {', '.join(sorted(unknown))} of this source")
            return [edits[name] for name in self.wanted.edit]
        path = os.path.join(self.output, f"drawn-{self.wanted.seed}-{self.wanted.count}.json")
        kept, digest = self.kept(path), digest_of(self.tree, ("src/", "meson"))
        if kept.get("digest") != digest:
            compiler = draw.Compiler(self.build, lambda file: self.place("draw", file))
            drawn = draw.draw(self.wanted.seed, modules, self.wanted.count, compiler.is_effective, self.jobs)
            kept = {"digest": digest, "edits": [edit.name for edit in drawn]}
            self.keep(path, kept)
        return [edits[name] for name in kept["edits"]]

    def source_of(self, edit):
        with open(os.path.join(self.tree, edit.file), encoding="utf-8") as stream:
            return stream.read()

    def diff(self, edit):
        source = self.source_of(edit)
        return "".join(difflib.unified_diff(source.splitlines(True), edit.applied(source).splitlines(True),
                                            "a/" + edit.file, "b/" + edit.file, n=2))

    def path_of(self, edit):
        return os.path.join(self.results, edit.name + ".json")

    def read_history(self):
        """Reads the results of earlier runs, of any version of the sources. They only set the order of the tests."""
        rows = [self.kept(os.path.join(self.results, name)) for name in sorted(os.listdir(self.results))]
        return [row for row in rows if row.get("module")]

    def order(self, edit, last):
        """The tests for an edit: first the one that caught it last time, then by the expected cost of a caught edit."""
        tried, caught, module = collections.Counter(), collections.Counter(), os.path.dirname(edit.file)
        target = self.tested.target_of(edit.file)
        with self.lock:
            for row in self.history:
                if row["module"] == module:
                    tried.update(row["passed"])
                    tried[row["caught_by"]] += 1
                    caught[row["caught_by"]] += 1
        return sorted(self.asked, key=lambda name: (
            name != last, expected_cost(self.baseline[name], tried[name], caught[name],
                                        target in self.tests.tests[name]["targets"]), name))

    def try_edit(self, edit, kept):
        """Runs the tests with an edit until one fails, except those that it passed before. Returns its row."""
        row = {"name": edit.name, "digest": self.digest, "module": os.path.dirname(edit.file), "kind": edit.kind,
               "caught_by": None, "by": None, "passed": [], "seconds": 0.0}
        if kept.get("digest") == self.digest and not self.wanted.fresh:
            row.update(passed=kept["passed"], seconds=kept["seconds"])
        place, begin = self.place(edit.name), time.monotonic()
        made = [self.tested.compile_text(edit.file, edit.applied(self.source_of(edit)), place, ["-w"])]
        programs = {}
        for name in self.order(edit, kept.get("caught_by")):
            altered = name not in row["passed"] and self.altered(name, programs, made, place)
            if not altered:
                continue
            limit = detect.limit_of({"seconds": self.baseline[name]})
            by, _ = self.tests.run(name, altered, place, limit)
            if by and self.tests.tests[name]["cmd"][0] not in altered.values():
                by, _ = self.tests.run(name, altered, place, limit)  # a script may time out once, so it must fail twice
            if not by and stamps_of(self.tree) != self.stamps:
                by = "tree"
            if by:
                row.update(caught_by=name, by=by)
                break
            row["passed"].append(name)
        row["seconds"] = round(row["seconds"] + time.monotonic() - begin, 1)
        if row["caught_by"]:
            shutil.rmtree(place)
        self.restore()
        return row

    def altered(self, name, programs, made, place):
        """The programs of a test, linked with the edit where they contain the edited file; none if no program does."""
        for program in self.tests.tests[name]["programs"]:
            if program not in programs:
                programs[program] = self.tested.program(program, made, place)
        own = {program: programs[program] for program in self.tests.tests[name]["programs"]}
        if not any(own.values()):
            return None
        return {program: path or os.path.join(self.tested.folder, program) for program, path in own.items()}

    def restore(self):
        """Restores the copy of the tree, because an edited program may write anywhere."""
        with self.lock:
            if stamps_of(self.tree) != self.stamps:
                mirror(self.whole, self.tree)
                self.stamps = stamps_of(self.tree)

    def outcome(self, edit):
        """The row of an edit, from an earlier run or from this one."""
        kept = self.kept(self.path_of(edit))
        known = kept.get("digest") == self.digest and not self.wanted.fresh
        if not (known and (kept["caught_by"] or self.asked <= set(kept["covers"]))):
            covers = self.asked | set(kept["covers"] if known else ())
            kept = self.try_edit(edit, kept)
            kept["covers"] = sorted(covers)
            self.keep(self.path_of(edit), kept)
            with self.lock:
                self.history.append(kept)
        self.tell(edit, kept)
        return kept

    def tell(self, edit, row):
        with self.lock:
            self.done += 1
            spent = time.monotonic() - self.begin
            left = spent / self.done * (self.total - self.done)
            what = f"caught by {row['caught_by']} in {row['seconds']:.0f} s" if row["caught_by"] else "not caught"
            print(f"{self.done}/{self.total} edits, {spent:.0f} s elapsed, about {left:.0f} s remaining "
                  f"({edit.name}, {edit.file}: {what})", file=sys.stderr, flush=True)

    def run(self, edits):
        self.total, self.begin = len(edits), time.monotonic()
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            rows = list(pool.map(self.outcome, edits))
        return list(zip(edits, rows))


def summary(campaign, results):
    """Prints the edits that survive and the counts. Returns whether enough edits were caught."""
    caught = [row for _, row in results if row["caught_by"]]
    left = [edit for edit, row in results if not row["caught_by"]]
    judged = [edit for edit in left if key_of(edit) in campaign.judged]
    survivors = [edit for edit in left if key_of(edit) not in campaign.judged]
    for title, edits in (("judged equivalent", judged), ("survivor", survivors)):
        for edit in edits:
            print(f"# {title}: {edit.name}, {edit.kind}, in {edit.function or 'no function'}")
            print(campaign.diff(edit))
            if edit in judged:
                print(f"# because {campaign.judged[key_of(edit)]}\n")
    path = os.path.join(campaign.output, "survivors.toml")
    with open(path, "w", encoding="utf-8") as stream:
        stream.write("\n".join(entry_of(edit) for edit in survivors))
    for what, of in (("suite", lambda row: row["caught_by"].split("/")[0]), ("test", lambda row: row["caught_by"]),
                     ("kind of edit", lambda row: row["kind"]), ("module", lambda row: row["module"])):
        counts = collections.Counter(of(row) for row in caught)
        print(f"# caught, by {what}: " + ", ".join(f"{name} {count}" for name, count in counts.most_common()))
    late = sum(row["by"] == "timeout" for row in caught)
    seconds = sum(row["seconds"] for _, row in results)
    share = 100.0 * len(caught) / max(1, len(results) - len(judged))
    print(f"# {len(results)} drawn, {len(caught)} caught ({late} of them out of time), {len(judged)} equivalent, "
          f"{len(survivors)} survivors; {share:.1f} % of those that are not equivalent are caught; "
          f"{seconds / max(1, len(results)):.1f} s an edit")
    if survivors:
        print(f"# entries for equivalents.toml, without reasons: {path}")
    return share >= ENOUGH


def interrupted(*_):
    """Ends the campaign. Finished results are kept, the running ones are lost."""
    detect.stop_all()
    os._exit(130)


def main(words):
    wanted = arguments(words)
    if not wanted.sanitize:  # the sanitizers reserve terabytes of address space
        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, resource.RLIM_INFINITY))
    resource.setrlimit(resource.RLIMIT_FSIZE, (MOST_FILE, resource.RLIM_INFINITY))
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
