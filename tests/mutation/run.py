#!/usr/bin/python3
"""Plants every fault of faults.toml, one at a time, and runs the detectors of detectors.toml with it until one catches it.

The detectors that first.toml names for a fault are all run with it, and first. Fails if no detector catches a fault, if a detector catches no fault, if a detector fails without a fault, or if a fault
does not fit the source. Prints TAP and writes the matrix as JSON (README.md describes it)."""

import argparse
import collections
import concurrent.futures
import hashlib
import json
import os
import shutil
import sys
import threading
import time

import detect
import first
import plant

SCHEMA = "pulloff-faults/1"


def arguments(words):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--build", default="build", metavar="DIR", help="the build folder (build)")
    parser.add_argument("--output", metavar="DIR", help="where to work and to leave matrix.json (BUILD/mutation)")
    parser.add_argument("--jobs", type=int, default=0, metavar="N", help="faults at a time (0: all cores)")
    parser.add_argument("--fault", action="append", metavar="NAME", help="only this fault; writes no matrix")
    parser.add_argument("--reuse", action="store_true",
                        help="do nothing when the matrix is of this program, these faults and cases, and whole")
    parser.add_argument("--all", action="store_true", help="run every detector with every fault that concerns it")
    parser.add_argument("--write", action="store_true",
                        help="with --all: write first.toml, the detectors that are run first with each fault")
    parser.add_argument("--fit", action="store_true", help="only whether every fault can be planted")
    given = parser.parse_args(words)
    if given.write and (not given.all or given.fault):
        parser.error("--write needs --all, without --fault")
    return given


def key_of(build, detectors):
    """sha256 of everything that the matrix depends on: programs, sources, cases, references and tests."""
    digest = hashlib.sha256()
    paths = [os.path.join(build.folder, program)
             for program in sorted({detect.program_of(detector) for detector in detectors})]
    for folder in ("src", "cases", "reference", "tests/cli", "tests/mutation"):
        for place, inner, names in os.walk(os.path.join(plant.SOURCE, folder)):
            inner[:] = sorted(set(inner) - {"__pycache__", "make"})
            paths += [os.path.join(place, name) for name in sorted(names)]
    for path in paths:
        with open(path, "rb") as stream:
            digest.update(hashlib.sha256(stream.read()).digest())
    return digest.hexdigest()


def concerns(detector, fault):
    """Whether a detector is run with a fault: for physics, cases, tables and the tests that the fault names."""
    if detector["name"] in fault["tests"]:
        return True
    return not detector.get("named") and (detector["kind"] != "test" or fault["kind"] == "harness")


def is_caught(fault, cell):
    """Whether a cell catches the fault. A pin that moved does not show wrong physics, and slow is not wrong."""
    weak = set() if fault["pin_suffices"] or fault["kind"] == "harness" else {"pin"}
    weak |= set() if fault["timeout_counts"] else {"timeout"}
    return bool(set(cell["by"]) - weak)


def span(seconds):
    return f"{seconds:.0f} s" if seconds < 90 else f"{int(seconds) // 60} min {int(seconds) % 60:02d} s"


class Campaign:
    """All faults and all detectors of one build."""

    def __init__(self, wanted):
        self.build = plant.Build(wanted.build)
        self.output = os.path.abspath(wanted.output or os.path.join(wanted.build, "mutation"))
        self.jobs = wanted.jobs or len(os.sched_getaffinity(0))
        self.detectors = detect.read_detectors(os.path.join(plant.HERE, "detectors.toml"))
        self.faults = plant.read_faults(os.path.join(plant.HERE, "faults.toml"))
        self.key = key_of(self.build, self.detectors)
        self.part, self.every = bool(wanted.fault), wanted.all
        self.first = first.read(os.path.join(plant.HERE, first.NAME))
        if self.part:
            self.choose(wanted.fault)
        self.baseline = {}
        self.catches = collections.Counter()  # number of faults that each detector has caught
        self.total, self.done, self.begin = 0, 0, time.monotonic()
        self.telling = threading.Lock()

    def choose(self, names):
        """Selects these faults, and the detectors that are run with at least one of them."""
        unknown = set(names) - {fault["name"] for fault in self.faults}
        if unknown:
            raise plant.Stale(f"there is no fault {', '.join(sorted(unknown))} in tests/mutation/faults.toml")
        self.faults = [fault for fault in self.faults if fault["name"] in names]
        self.detectors = [detector for detector in self.detectors
                          if any(concerns(detector, fault) for fault in self.faults)]

    def place(self, name):
        path = os.path.join(self.output, name)
        shutil.rmtree(path, ignore_errors=True)
        os.makedirs(path)
        return path

    def run_baseline(self):
        """Runs every detector on the program without a fault."""
        def one(detector):
            place = self.place(os.path.join("baseline", detector["name"]))
            return detect.run(detector, os.path.join(self.build.folder, detect.program_of(detector)), place)
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            cells = pool.map(one, self.detectors)
        self.baseline = {detector["name"]: cell for detector, cell in zip(self.detectors, cells)}

    def turns(self, fault):
        """The detectors of a fault in the order in which they are run, each with whether it is run in any case: those
        of first.toml, then the others, the cheapest first."""
        named = self.first.get(fault["name"], [])
        mine = [detector for detector in self.detectors if concerns(detector, fault)]
        mine.sort(key=lambda detector: (detector["name"] not in named, self.baseline[detector["name"]]["seconds"]))
        return [(detector, self.every or detector["name"] in named) for detector in mine]

    def run_with(self, fault, turns, cells):
        """Plants a fault and runs detectors with it until one catches it; adds their cells to `cells`. Detectors whose
        program does not contain the file have no cell."""
        place = self.place(fault["name"])
        made, programs = self.build.objects_of(fault, place), {}
        for detector, always in turns:
            if not always and any(cell["caught"] for cell in cells.values()):
                break
            name = detect.program_of(detector)
            if name not in programs:
                programs[name] = self.build.program(name, made, place)
            if not programs[name]:
                continue
            cell = detect.run(detector, programs[name], place, self.baseline[detector["name"]])
            cell["caught"] = is_caught(fault, cell) and not self.baseline[detector["name"]]["by"]
            del cell["parts"]
            cells[detector["name"]] = cell
            with self.telling:
                self.catches[detector["name"]] += cell["caught"]
        if any(cell["caught"] for cell in cells.values()):
            shutil.rmtree(place)

    def run_fault(self, fault):
        """The row of a fault: its cells by detector. Detectors that are not run with the fault have no cell."""
        row = {key: fault[key] for key in ("name", "kind", "what", "file")}
        row.update(cells={}, caught=False, problem="")
        try:
            self.run_with(fault, self.turns(fault), row["cells"])
        except plant.Stale as error:
            row["problem"] = str(error)
        row["caught"] = any(cell["caught"] for cell in row["cells"].values())
        self.tell(f"{fault['name']}: {'caught' if row['caught'] else 'not caught'}")
        return row

    def prove(self, detector, rows):
        """Runs a detector that has caught no fault with further faults until it catches one."""
        for fault, row in zip(self.faults, rows):
            if self.catches[detector["name"]]:
                return
            if concerns(detector, fault) and detector["name"] not in row["cells"] and not row["problem"]:
                self.run_with(fault, [(detector, True)], row["cells"])

    def prove_idle(self, rows):
        """Runs the detectors that have caught no fault with the faults with which they were not run."""
        idle = [detector for detector in self.detectors if not self.catches[detector["name"]]]
        for detector in [] if self.part or self.every else idle:
            print(f"{detector['name']} has caught no fault yet: it is run with the others", file=sys.stderr, flush=True)
            self.prove(detector, rows)

    def tell(self, what):
        """Prints the progress in the form of `pulloff run`."""
        with self.telling:
            self.done += 1
            spent = time.monotonic() - self.begin
            left = spent / self.done * (self.total - self.done)
            print(f"{self.done}/{self.total} faults, {span(spent)} elapsed, about {span(left)} remaining ({what})",
                  file=sys.stderr, flush=True)

    def run_faults(self, faults):
        self.total, self.begin = len(faults), time.monotonic()
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            rows = list(pool.map(self.run_fault, faults))
        self.prove_idle(rows)
        return rows

    def matrix(self, rows, seconds):
        detectors = [{"name": detector["name"], "kind": detector["kind"], "title": detector["title"],
                      "seconds": self.baseline[detector["name"]]["seconds"],
                      "passes": not self.baseline[detector["name"]]["by"],
                      "catches": self.catches[detector["name"]]}
                     for detector in self.detectors]
        return {"schema": SCHEMA, "key": self.key, "seconds": round(seconds, 1), "detectors": detectors, "faults": rows,
                "passes": all(row["caught"] for row in rows) and
                all(detector["passes"] and (detector["catches"] or self.part) for detector in detectors)}


def tell(tap, number, passes, name, why):
    tap.append(f"{'ok' if passes else 'not ok'} {number} - {name}")
    if not passes:
        tap.extend("# " + line for line in why.splitlines())


def tap_of(matrix, part):
    """One line for each detector and each fault. If only some faults are run, a detector need not catch any."""
    tap, number = [], 0
    for detector in matrix["detectors"]:
        why = "it fails without any fault" if not detector["passes"] else "it caught no fault"
        passes = detector["passes"] and (detector["catches"] or part)
        number += 1
        tell(tap, number, passes, f"detector {detector['name']}", why)
    for row in matrix["faults"]:
        number += 1
        slow = [name for name, cell in row["cells"].items() if "timeout" in cell["by"]]
        pins = [name for name, cell in row["cells"].items() if cell["by"] == ["pin"]]
        why = row["problem"] or f"nobody caught it: {row['what']}"
        why += f"\nout of time: {', '.join(slow)}" if slow else ""
        why += f"\nonly a pin moved: {', '.join(pins)}" if pins else ""
        tell(tap, number, row["caught"], f"fault {row['name']}", why)
    return f"TAP version 13\n1..{number}\n" + "\n".join(tap)


def table_of(matrix):
    """The matrix as a table in TAP comments."""
    names = [detector["name"] for detector in matrix["detectors"]]
    width = max(len(row["name"]) for row in matrix["faults"])
    signs = {"oracle": "O", "pin": "p", "no_result": "n", "test": "T", "refused": "R", "timeout": "t"}
    lines = ["O oracle, T test, n no result, R refused, p pin, t out of time, . passed, blank: not run with it"]
    for place in range(max(map(len, names))):
        lines.append(" " * width + " " + " ".join(name[place:place + 1] or " " for name in names))
    for row in matrix["faults"]:
        cells = (row["cells"].get(name) for name in names)
        marks = (" " if cell is None else next((signs[by] for by in signs if by in cell["by"]), ".") for cell in cells)
        lines.append(f"{row['name']:{width}} {' '.join(marks)}".rstrip())
    return "\n".join("# " + line for line in lines)


def is_kept(path, key):
    try:
        with open(path, encoding="utf-8") as stream:
            kept = json.load(stream)
    except (OSError, ValueError):
        return False
    return kept.get("schema") == SCHEMA and kept.get("key") == key and kept.get("passes")


def print_fit(folder):
    """Prints the faults that cannot be planted in a build. Returns whether there are any."""
    build, stale = plant.Build(folder), 0
    for fault in plant.read_faults(os.path.join(plant.HERE, "faults.toml")):
        try:
            build.check_fit(fault)
        except (plant.Stale, OSError) as error:
            print(f"{fault['name']}: {error}")
            stale += 1
    return 1 if stale else 0


def main(words):
    wanted = arguments(words)
    begin = time.monotonic()
    if wanted.fit:
        return print_fit(wanted.build)
    try:
        campaign = Campaign(wanted)
    except (plant.Stale, OSError) as error:
        print(f"Bail out! {error}")
        return 4
    path = os.path.join(campaign.output, "matrix.json")
    if wanted.reuse and is_kept(path, campaign.key):
        print(f"# kept: {path}")
        return 0
    campaign.run_baseline()
    matrix = campaign.matrix(campaign.run_faults(campaign.faults), time.monotonic() - begin)
    if not campaign.part:
        with open(path + ".new", "w", encoding="utf-8") as stream:
            json.dump(matrix, stream, indent=1)
            stream.write("\n")
        os.replace(path + ".new", path)
    if wanted.write:
        first.write(os.path.join(plant.HERE, first.NAME), matrix)
    print(tap_of(matrix, campaign.part))
    print(table_of(matrix))
    print(f"# {len(campaign.faults)} faults, {time.monotonic() - begin:.0f} s")
    return 0 if matrix["passes"] else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
