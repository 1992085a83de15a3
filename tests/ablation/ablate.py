#!/usr/bin/python3
"""What is lost without each mechanism of the solver.

    ablate.py                    all mechanisms that results.csv does not have yet
    ablate.py --only 'GMRES'     those whose name matches, measured anew
    ablate.py --without 'a|b'    all that match switched off at once; prints the rows and keeps nothing

A copy of the source in build/ablation has one mechanism of mechanisms.toml switched off by an edit, is built, and runs the
commands of scenes.txt. The results are compared with solutions at a tolerance of 1e-8 and with those of the unchanged
source. Then doc/mechanisms.md is written from the table.

Exit code: 0 all is measured, 1 a source does not build or the unchanged source does not solve, 130 interrupted."""

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
import scenes

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
TABLE = os.path.join(HERE, "results.csv")
PAGE = os.path.join(ROOT, "doc", "mechanisms.md")
TIGHT = "1e-8"
LONGEST = 60                # processor seconds of one command
COLUMNS = ("mechanism", "set", "scenes", "changed", "failed", "lost", "extra", "violated", "worst_error", "worst_energy",
           "moved", *(f"{name}_ratio" for name in outcome.COUNTERS))
SMALLEST = 0.015            # change of a counter that the page shows
SETS = {"small": "; cheap scenes of all kinds", "wavy": "", "general": "; any law, profile and number of waves",
        "soft": "; Tabor parameters from 100 to 10,000, sharp edges, steep laws"}
HEAD = """# The mechanisms of the solver

What each mechanism is for, and what happens without it. `tests/ablation/ablate.py` switches one off at a time in a copy of the source and solves {scenes} scenes in {sets} sets ([how](../tests/ablation/README.md)): {columns}. [The method](method.md) explains the mechanisms.

Effects: points of the branch and Newton iterations without the mechanism over those with it, of the scenes that are solved both times; scenes that are no longer solved; special points lost or spurious beside a solution at a tolerance of 1e-8; stated errors that this solution violates. A set is named where a counter changes by 1.5 % or more, or something is lost. A row stays as it is until its mechanism is measured anew.

| mechanism | what it is for | effects of switching it off |
|---|---|---|
{lines}
"""


def mechanisms():
    with open(os.path.join(HERE, "mechanisms.toml"), "rb") as stream:
        return tomllib.load(stream)["mechanism"]


def edits_of(mechanism):
    return [mechanism, *mechanism.get("more", [])]


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


class Copy:
    """A copy of the source in a build folder of its own."""

    def __init__(self, folder, jobs):
        self.folder, self.jobs = folder, jobs
        self.source, self.build = os.path.join(folder, "tree"), os.path.join(folder, "build")
        self.program = os.path.join(self.build, "src", "cli", "pulloff")

    def fill(self):
        """Copies what differs, so that the rest is not built again."""
        listed = subprocess.run(["git", "-C", ROOT, "ls-files"], check=True, capture_output=True, text=True).stdout.split("\n")
        for name in listed:
            if not name or name.startswith("tests/") or not os.path.isfile(os.path.join(ROOT, name)):
                continue
            source, target = os.path.join(ROOT, name), os.path.join(self.source, name)
            if not (os.path.exists(target) and filecmp.cmp(source, target, shallow=False)):
                os.makedirs(os.path.dirname(target), exist_ok=True)
                shutil.copyfile(source, target)

    def compile(self, edits=()):
        """Builds the source with these edits. Returned: whether it builds."""
        self.fill()
        for edit in edits:
            path = os.path.join(self.source, edit["file"])
            with open(path, encoding="utf-8") as stream:
                text = stream.read()
            assert text.count(edit["old"]) == 1, f"{edit['file']}: {edit['old']}"
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(text.replace(edit["old"], edit["new"]))
        if not os.path.exists(os.path.join(self.build, "build.ninja")):
            subprocess.run(["meson", "setup", "-Dtests=false", self.build, self.source], check=True,
                           stdout=subprocess.DEVNULL)
        return subprocess.run(["ninja", "-C", self.build, "src/cli/pulloff"], stdout=subprocess.DEVNULL,
                              check=False).returncode == 0

    def documents(self, commands):
        """In the order of the commands, `jobs` at a time."""
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            return list(pool.map(lambda words: run(self.program, words), commands))


class Campaign:
    """The sets solved by the unchanged source, and by any other."""

    def __init__(self, copy, sets):
        self.copy, self.sets = copy, sets
        self.base = {name: copy.documents(commands) for name, commands in sets.items()}
        self.truth = self.truths()

    def truths(self):
        """Solutions at the tight tolerance; kept in the folder of the copy, as they take longest."""
        path = os.path.join(self.copy.folder, "truth.json")
        known = {}
        if os.path.exists(path):
            with open(path, encoding="utf-8") as stream:
                known = json.load(stream)
        wanted = [tight(words) for commands in self.sets.values() for words in commands]
        missing = [words for words in wanted if words and " ".join(words) not in known]
        for words, document in zip(missing, self.copy.documents(missing)):
            known[" ".join(words)] = document
        with open(path, "w", encoding="utf-8") as stream:
            json.dump(known, stream)
        return {name: [words and known[" ".join(words)] for words in map(tight, commands)] for name, commands in self.sets.items()}

    def rows(self, name, documents):
        """One row a set. Scenes without a tight solution are judged by the unchanged source."""
        for of, found in documents.items():
            tally = outcome.Tally()
            for one, base, truth in zip(found, self.base[of], self.truth[of]):
                if not outcome.is_solved(base):
                    continue
                tally.add(one, base, truth if truth and outcome.is_solved(truth) else None)
            both = [(one, base) for one, base in zip(found, self.base[of]) if outcome.is_solved(one) and outcome.is_solved(base)]
            now, before = outcome.cost(one for one, _ in both), outcome.cost(base for _, base in both)
            ratios = {f"{key}_ratio": f"{now[key] / before[key]:.4f}" if before[key] else "" for key in outcome.COUNTERS}
            yield dict(tally.row(), mechanism=name, set=of, scenes=len(found), **ratios)

    def measure(self, name, edits):
        if not self.copy.compile(edits):
            return None
        return list(self.rows(name, {of: self.copy.documents(commands) for of, commands in self.sets.items()}))


def read_rows():
    if not os.path.exists(TABLE):
        return {}
    with open(TABLE, encoding="utf-8", newline="") as stream:
        found = {}
        for row in csv.DictReader(stream):
            found.setdefault(row["mechanism"], {})[row["set"]] = row
        return found


def write_rows(rows):
    with open(TABLE + ".new", "w", encoding="utf-8", newline="") as stream:
        writer = csv.DictWriter(stream, COLUMNS, restval="", extrasaction="ignore", lineterminator="\n")
        writer.writeheader()
        for sets in rows.values():
            writer.writerows(sets.values())
    os.replace(TABLE + ".new", TABLE)


def effect(row, base):
    """A few words on one mechanism and set."""
    words = []
    for key, text in (("points", "points"), ("newton_iterations", "Newton")):
        ratio = float(row[f"{key}_ratio"] or 1.0)
        if abs(ratio - 1.0) >= SMALLEST:
            words.append(f"{text} ×{ratio:.2f}")
    for key, text in (("failed", "unsolved"), ("lost", "lost"), ("extra", "spurious"), ("violated", "violated")):
        more = int(row[key]) - int(base[key])
        if more:
            words.append(f"{text} {more:+d}".replace("-", "−"))
    return ", ".join(words)


def page(rows):
    """The text of doc/mechanisms.md."""
    base = rows["unchanged"]
    lines = []
    for mechanism in mechanisms():
        row = rows.get(mechanism["name"])
        effects = [f"{of}: {what}" for of in base if (what := effect(row[of], base[of]))] if row else ["not measured"]
        kept = " " + mechanism["kept"] if "kept" in mechanism else ""
        lines.append(f"| {mechanism['name']} | {mechanism['for']}.{kept} | {'; '.join(effects) or '–'} |")
    sets = ", ".join(f"*{of}* ({row['scenes']}{SETS[of]})" for of, row in base.items())
    return HEAD.format(scenes=sum(int(row["scenes"]) for row in base.values()), sets=len(base), columns=sets, lines="\n".join(lines))


def write_page(rows):
    with open(PAGE, "w", encoding="utf-8") as stream:
        stream.write(page(rows))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", help="mechanisms whose name matches this regular expression")
    parser.add_argument("--without", help="mechanisms that are switched off together")
    parser.add_argument("--page", action="store_true", help="only writes the page")
    parser.add_argument("--sets", default="", help="sets whose name matches; what is measured is printed and not kept")
    parser.add_argument("--jobs", type=int, default=1, help="commands that are run at a time (1)")
    parser.add_argument("--folder", default=os.path.join(ROOT, "build", "ablation"), help="for the copy of the source")
    return parser.parse_args()


def show(rows):
    for row in rows:
        print(" ".join(f"{key}={row[key]}" for key in COLUMNS), flush=True)


def main():
    wanted = arguments()
    rows = read_rows()
    names = [m["name"] for m in mechanisms()]
    rows = {name: row for name, row in rows.items() if name in names or name == "unchanged"}
    if wanted.page:
        write_page(rows)
        return 0
    sets = {name: commands for name, commands in scenes.read().items() if re.search(wanted.sets, name)}
    copy = Copy(wanted.folder, wanted.jobs)
    if not copy.compile():
        print("ablate.py: the unchanged source does not build", file=sys.stderr)
        return 1
    campaign = Campaign(copy, sets)
    for of, documents in campaign.base.items():
        for words, found in zip(sets[of], documents):
            if not outcome.is_solved(found):
                print(f"ablate.py: not solved: pulloff {' '.join(words)}", file=sys.stderr)
    unchanged = list(campaign.rows("unchanged", campaign.base))
    show(unchanged)
    if wanted.without:
        edits = [edit for m in mechanisms() if re.search(wanted.without, m["name"]) for edit in edits_of(m)]
        show(campaign.measure(wanted.without, edits) or [])
        return 0
    if not wanted.sets:
        rows["unchanged"] = {row["set"]: row for row in unchanged}
    for mechanism in mechanisms():
        name = mechanism["name"]
        if not (re.search(wanted.only, name) if wanted.only else name not in rows):
            continue
        found = campaign.measure(name, edits_of(mechanism))
        if found is None:
            print(f"ablate.py: does not build without: {name}", file=sys.stderr)
            return 1
        show(found)
        if not wanted.sets:
            rows[name] = {row["set"]: row for row in found}
            write_rows(rows)
    if not wanted.sets:
        write_rows(rows)
        write_page(rows)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
