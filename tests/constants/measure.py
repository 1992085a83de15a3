#!/usr/bin/python3
"""What half and twice the value of each constant of the solver do to errors and work.

    measure.py                         all that doc/constants.csv does not have yet
    measure.py --only 'po_newton|FAR'  only constants whose file or name matches
    measure.py --fresh                 everything anew

For each constant of constants.toml with a measurement, a copy of the source has that one value changed, is built, and
runs the commands of scenes.txt. The results are compared with solutions at a tolerance of 1e-8 and with those of the
unchanged source. A row is written to doc/constants.csv as soon as it is known, so that an interrupted run goes on.
Then `document.py` writes doc/constants.md.

Exit code: 0 all is measured, 1 the unchanged source does not build or solve, 130 interrupted."""

import argparse
import concurrent.futures
import csv
import filecmp
import json
import os
import re
import shutil
import subprocess
import sys
import tomllib

import outcome
import scan
import scenes

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
CSV = os.path.join(ROOT, "doc", "constants.csv")
TIGHT = "1e-8"
LONGEST = 5                 # processor seconds of one command
MOST_CRASHES = 4            # commands without a document after which the others are taken for such, too
RESULTS = ("scenes", "changed", "failed", "lost", "extra", "median_error", "worst_error", "worst_energy", "stated", "held",
           "violated", "moved")
COLUMNS = ("file", "name", "value", "side", "tried", *RESULTS, *(f"{name}_ratio" for name in outcome.COUNTERS),
           "work_ratio")
UNCHANGED = ("-", "-", "", "")

# Commands that use a file, by a regular expression; a module stands for its files that are not here. The others are not
# run: their results are those of the unchanged source.
FIXED, FOLLOW, SOLVED = r"--scheme", r"^follow", r"^(solve|follow)"
PANELS, RIGID = r"^(solve|follow) (?!.*--scheme)(?!--tabor (0|1e-6) )", r"--tabor (0|1e-6) "
USED_BY = {
    **{module: SOLVED for module in ("scene", "bem", "equilibrium", "continuation", "path", "result", "solve")}, "series": FOLLOW,
    "po_triangle.c": r"--scheme triangle", "po_surface.c": FIXED + "|" + RIGID, "po_rigid.c": RIGID, "po_rigid_trace.c": RIGID,
    "po_wavy_rigid.c": r"^theory rigid", "po_jkr_path.c": r"preload|hysteresis", "po_theory_forces.c": SOLVED,
    "po_diagnosis.c": r"diagnostics", "po_diagnose.h": r"diagnostics", "po_follow.c": FOLLOW,
    **{name: PANELS for name in ("po_panel_table.h", "po_panels.h", "po_moving_edges.c", "po_moving_edges.h",
                                 "po_refine.c", "po_resolution.c", "po_resolution.h", "po_extent.c")}}

# What is measured first.
ORDER = ("solve", "continuation", "equilibrium", "bem", "series", "result", "scene", "path", "linear", "math", "theory")


def module_of(path):
    return os.path.basename(os.path.dirname(path))


def table():
    """Entries of constants.toml: the file and the name are keys like the others."""
    with open(os.path.join(HERE, "constants.toml"), "rb") as stream:
        files = tomllib.load(stream)
    del files["labels"]
    return [dict(entry, file=file, name=name) for file, names in files.items() for name, entry in names.items()]


def is_measured(entry):
    return entry["kind"] in ("tuned", "limit") and not entry.get("unmeasured")


def wanted_keys(places):
    """Keys of all rows that there should be."""
    return {(entry["file"], entry["name"], places[entry["file"], entry["name"]][0], side) for entry in table()
            if is_measured(entry) and (entry["file"], entry["name"]) in places for side in ("half", "twice")}


def tried(entry, value, side):
    """The text that takes the place of the value."""
    if side in entry:
        return str(entry[side])
    if re.fullmatch(r"\d+", value):
        return str(max(1, int(value) // 2) if side == "half" else 2 * int(value))
    return f"({'0.5' if side == 'half' else '2.0'} * ({value}))"


def run(program, words):
    """The document of a command; one without a document has the status `crashed`."""
    done = subprocess.run(["prlimit", f"--cpu={LONGEST}", program, *words, "--json"], capture_output=True, check=False,
                          text=True)
    try:
        return json.loads(done.stdout)
    except ValueError:
        return {"status": "crashed", "reason": f"exit code {done.returncode}"}


def tight(words):
    """The same command at the tight tolerance, every scene of a line traced; None for what has no tolerance."""
    if "--tolerance" not in words or "diagnostics" in words:
        return None
    place = words.index("--tolerance") + 1
    every = ["--checkpoint-every", "1"] if words[0] == "follow" and "folds" not in words else []
    return [*words[:place], TIGHT, *words[place + 1:], *every]


def copy_if_different(source, target):
    """Leaves a file as it is that has the same content, so that it is not built again."""
    if not (os.path.exists(target) and filecmp.cmp(source, target, shallow=False)):
        os.makedirs(os.path.dirname(target), exist_ok=True)
        shutil.copyfile(source, target)


class Copy:
    """A copy of the source in a build folder of its own."""

    def __init__(self, folder, jobs=1):
        self.folder, self.jobs = folder, jobs
        self.source, self.build = os.path.join(folder, "tree"), os.path.join(folder, "build")
        self.program = os.path.join(self.build, "src", "cli", "pulloff")

    def make(self):
        """Returned: whether the unchanged source builds."""
        for name in ("meson.build", "meson_options.txt", *(os.path.relpath(file, ROOT) for file in self.files())):
            copy_if_different(os.path.join(ROOT, name), os.path.join(self.source, name))
        if not os.path.exists(os.path.join(self.build, "build.ninja")):
            subprocess.run(["meson", "setup", "-Dtests=false", self.build, self.source], check=True,
                           stdout=subprocess.DEVNULL)
        return self.compile()

    @staticmethod
    def files():
        return [os.path.join(folder, file) for folder, _, files in os.walk(os.path.join(ROOT, "src")) for file in files]

    def compile(self):
        return subprocess.run(["ninja", "-j1", "-C", self.build, "src/cli/pulloff"], stdout=subprocess.DEVNULL,
                              check=False).returncode == 0

    def documents(self, commands):
        """In the order of the commands, `jobs` at a time."""
        crashes = []

        def document(words):
            found = run(self.program, words) if len(crashes) < MOST_CRASHES else {"status": "crashed"}
            if found.get("status") == "crashed":
                crashes.append(words)
            return found

        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            return list(pool.map(document, commands))

    def with_value(self, place, text, work):
        """Calls `work` with one value changed. Returned: what it returns; None when that does not build."""
        value, path, begin, end = place
        path = os.path.join(self.source, os.path.relpath(path, ROOT))
        with open(path, encoding="utf-8") as stream:
            before = stream.read()
        assert before[begin:end] == value
        try:
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(before[:begin] + text + before[end:])
            return work() if self.compile() else None
        finally:
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(before)


class Results:
    """Rows of the table, kept in a file."""

    def __init__(self, path):
        self.path, self.rows = path, {}
        if os.path.exists(path):
            with open(path, encoding="utf-8", newline="") as stream:
                lines = [line for line in stream if not line.startswith("#")]
            self.rows = {(row["file"], row["name"], row["value"], row["side"]): row for row in csv.DictReader(lines)}

    def put(self, key, row):
        self.rows[key] = {**row, **dict(zip(COLUMNS[:4], key))}
        with open(self.path + ".new", "w", encoding="utf-8", newline="") as stream:
            stream.write("# what: each constant at half and at twice its value, tests/constants/measure.py\n")
            writer = csv.DictWriter(stream, COLUMNS, restval="", lineterminator="\n")
            writer.writeheader()
            writer.writerows(self.rows[key] for key in sorted(self.rows))
        os.replace(self.path + ".new", self.path)

    def keep(self, keys):
        """Drops what is not among these; a constant that moved to another file takes its rows along."""
        stale = {key: row for key, row in self.rows.items() if key not in keys}
        self.rows = {key: row for key, row in self.rows.items() if key in keys}
        for key in keys:
            same = [old for old in stale if old[1:] == key[1:]]
            if key not in self.rows and len(same) == 1:
                self.rows[key] = dict(stale[same[0]], file=key[0])


class Campaign:
    """The set solved by the unchanged source, and by any other."""

    def __init__(self, copy, commands):
        self.copy, self.commands = copy, commands
        self.base = copy.documents(commands)
        self.cost = outcome.cost(self.base)
        self.truth = self.truths()

    def truths(self):
        """Solutions at the tight tolerance; kept in the folder of the copy, as they take longest."""
        path = os.path.join(self.copy.folder, "truth.json")
        known = {}
        if os.path.exists(path):
            with open(path, encoding="utf-8") as stream:
                known = json.load(stream)
        for words in map(tight, self.commands):
            if words and " ".join(words) not in known:
                known[" ".join(words)] = run(self.copy.program, words)
        with open(path, "w", encoding="utf-8") as stream:
            json.dump(known, stream)
        return [known[" ".join(words)] if words else None for words in map(tight, self.commands)]

    def unsolved(self):
        return [" ".join(words) for words, base, truth in zip(self.commands, self.base, self.truth)
                if not outcome.is_solved(base) or (truth and not outcome.is_solved(truth))]

    def row(self, documents):
        tally = outcome.Tally()
        for found, base, truth in zip(documents, self.base, self.truth):
            tally.add(found, base, truth)
        row = dict(tally.row(), scenes=len(documents))
        both = [(found, base) for found, base in zip(documents, self.base) if outcome.is_solved(found)]
        now, before = outcome.cost(found for found, _ in both), outcome.cost(base for _, base in both)
        for name, value in now.items():
            row[f"{name}_ratio"] = f"{value / before[name]:.4f}" if before[name] else ""
        return row

    def measure(self, place, text):
        pattern = USED_BY.get(os.path.basename(place[1]), USED_BY.get(module_of(place[1]), ""))
        use = [re.search(pattern, " ".join(words)) for words in self.commands]
        found = self.copy.with_value(place, text, lambda: iter(self.copy.documents(
            [words for words, used in zip(self.commands, use) if used])))
        documents = found and [next(found) if used else base for used, base in zip(use, self.base)]
        return dict(self.row(documents) if documents else {"failed": "not built"}, tried=text)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", help="constants whose file or name matches this regular expression")
    parser.add_argument("--fresh", action="store_true", help="measures what was measured before, too")
    parser.add_argument("--missing", action="store_true", help="prints what is not measured; exit code 1 if something is")
    parser.add_argument("--jobs", type=int, default=1, help="commands that are run at a time (1)")
    parser.add_argument("--folder", default=os.path.join(ROOT, "build", "constants"), help="for the copy of the source")
    parser.add_argument("--output", default=CSV, help="the table of results (doc/constants.csv)")
    return parser.parse_args()


def main():
    wanted = arguments()
    places = scan.constants(ROOT)
    entries = [entry for entry in table() if is_measured(entry) and (entry["file"], entry["name"]) in places]
    kinds = {(entry["file"], entry["name"]): entry["kind"] for entry in entries}
    results = Results(wanted.output)
    tasks = []
    results.keep(wanted_keys(places) | {UNCHANGED})
    for entry in entries:
        place = places[entry["file"], entry["name"]]
        for side in ("half", "twice"):
            key = (entry["file"], entry["name"], place[0], side)
            if re.search(wanted.only, f"{entry['file']} {entry['name']}") and (wanted.fresh or key not in results.rows):
                tasks.append((key, place, tried(entry, place[0], side)))
    tasks.sort(key=lambda task: (kinds[task[0][:2]] != "tuned", ORDER.index(module_of(task[1][1]))))
    if wanted.missing:
        print("\n".join(" ".join(key) for key, _, _ in tasks))
        return int(bool(tasks))
    copy = Copy(wanted.folder, wanted.jobs)
    if not copy.make():
        print("measure.py: the unchanged source does not build", file=sys.stderr)
        return 1
    campaign = Campaign(copy, scenes.read())
    unsolved = campaign.unsolved()
    if unsolved:
        print(f"measure.py: {len(unsolved)} commands are not solved, the first of them: pulloff {unsolved[0]}",
              file=sys.stderr)
        return 1
    results.put(UNCHANGED, dict(campaign.row(campaign.base), tried=""))
    for k, (key, place, text) in enumerate(tasks):
        half = results.rows.get((*key[:3], "half"), {})
        if kinds[key[:2]] == "limit" and key[3] == "twice" and half.get("changed") in ("0", 0):
            row = dict(half, tried=text)            # a limit that is not met at half its value
        else:
            row = campaign.measure(place, text)
        results.put(key, row)
        print(f"{k + 1}/{len(tasks)} {key[0]} {key[1]} {key[3]}: {text}: changed {row.get('changed')}, "
              f"failed {row['failed']}, work {row.get('work_ratio')}, worst {row.get('worst_error')}", flush=True)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
