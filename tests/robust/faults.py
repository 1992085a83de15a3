#!/usr/bin/python3
"""Lets one allocation or system call after another fail, and checks how the program ends.

A command whose k-th call fails must end as an undisturbed one, except for times, or with a message and an exit code
other than 0. It must not leak memory. Every file must be as before, as after an undisturbed run, or absent, and the
next undisturbed run must give the usual results. Prints TAP, one line for each command and kind of fault
(README.md)."""

import argparse
import concurrent.futures
import os
import random
import shutil
import sys
import tempfile

from trial import Command, Place

HERE = os.path.dirname(os.path.abspath(__file__))
RUN = ("--jobs", "1", "--output", "run")
SI = ("--from-physical", "--modulus-pa", "2e9", "--work-j-per-m2", "0.05", "--distance-m", "3e-10", "--radius-m", "1e-7")
WAVES = ("--amplitude", "0.9", "--wavelength", "21")
SHARDS = tuple(("run", "tiny", "--jobs", "1", "--shard", f"{k}/2", "--output", f"shards/{k}") for k in (1, 2))

COMMANDS = [
    Command("theory-guduru", ("theory", "guduru", "--tabor", "5", "--amplitude", "10", "--wavelength", "20",
                              "--radius", "100", "--json")),
    Command("theory-guduru-text", ("theory", "guduru", "--tabor", "5", "--amplitude", "10", "--wavelength", "20",
                                   "--contact-radius", "12")),
    Command("theory-jkr-si", ("theory", "jkr", *SI, "--json")),
    Command("theory-bradley", ("theory", "bradley", "--approach", "-0.3", "--json")),
    Command("theory-kesari-lew", ("theory", "kesari-lew", "--tabor", "2", *WAVES, "--contact-radius", "9", "--json")),
    Command("theory-rigid", ("theory", "rigid", *WAVES, "--approach", "-0.3", "--json")),
    Command("list", ("list", "--json")),
    Command("list-references", ("list", "--references", "--json")),
    Command("plan", ("plan", "tiny")),
    Command("solve", ("solve", "--tabor", "1")),
    Command("solve-json", ("solve", "--tabor", "1", "--json", "--want", "hysteresis,diagnostics", "--scheme", "triangle",
                           "--nodes", "61", "--curve", "curve.csv", "--profile", "profile.csv"), writes=True),
    Command("solve-wavy", ("solve", "--tabor", "2", *WAVES, "--outer-radius", "100", "--json", "--want",
                           "curve,profile,diagnostics", "--tolerance", "1e-3")),
    Command("solve-rigid", ("solve", "--tabor", "0", *WAVES, *("--json", "--want", "curve,profile"))),
    Command("solve-si", ("solve", *SI, "--json", "--tolerance", "1e-3", "--want", "curve,profile")),
    Command("follow", ("follow", "--key", "tabor", "--from", "0.7", "--to", "1", "--points", "4", "--tolerance", "1e-3",
                       "--json")),
    Command("follow-folds", ("follow", "--of", "folds", "--key", "tabor", "--from", "1.2", "--to", "1.5", "--points",
                             "3", "--tolerance", "1e-3")),
    Command("run", ("run", "tiny", *RUN), writes=True),
    Command("run-shard", SHARDS[0], writes=True),
    Command("verify", ("verify", "tiny", *RUN), writes=True),
    Command("verify-kept", ("verify", "tiny", "--junit", "junit.xml", *RUN), (("run", "tiny", *RUN),), True),
    Command("verify-resumed", ("verify", "tiny", *RUN), (("run", "tiny", "--points", "1", *RUN),), True),
    Command("verify-fresh", ("verify", "tiny", "--fresh", *RUN), (("run", "tiny", *RUN),), True),
    Command("explain", ("explain", "tiny", "--all", "--json", *RUN), (("run", "tiny", *RUN),)),
    Command("merge", ("merge", "shards/1", "shards/2", "--output", "run"), SHARDS, True),
    Command("bless", ("bless", "tiny", "--reason", "because", *RUN), (("run", "tiny", *RUN),), True),
    Command("report", ("report", "--run", "run", "--output", "report"), (("run", "tiny", *RUN),), True),
]

# libyaml 0.2.5 leaks the current node if the memory for the stack of its parser cannot be allocated.
LEAKS_OF_ITS_OWN = "/libyaml-0.so"

KINDS = ("allocate", "open", "read", "write", "short", "close", "fsync", "rename", "mkdir", "unlink")
MODES = ("once", "on", "kill")


def judge(command, kind, ending, right, before):
    """What is wrong with the end of a command; '' if nothing is."""
    if ending.code is None:
        return "does not end"
    if ending.code < 0:
        return f"ends by signal {-ending.code}"
    for path, contents in ending.files.items():
        if contents not in (before.get(path), right.files.get(path)) and not path.endswith("points.jsonl"):
            return f"{path} is neither as before nor as after"
    for path in before:
        if path not in ending.files and path in right.files:
            return f"{path} is lost"
    grown = [place for place, count in ending.report["kept"].items()
             if count > right.report["kept"].get(place, 0) and LEAKS_OF_ITS_OWN not in place]
    if grown:
        return f"leaks {', '.join(grown)}"
    if ending.code != 0:
        if len(ending.errors) != 1:
            return f"ends with {ending.code} and {len(ending.errors)} lines of message: {ending.errors[:2]}"
        if kind == "allocate" and "memory" not in ending.errors[0]:
            return f"the message does not mention memory: {ending.errors[0]}"
        return ""
    if ending.output != right.output:
        return "ends with 0, but its output differs"
    if ending.errors != right.errors:
        return f"ends with 0, but prints {ending.errors[:1]}"
    if ending.files != right.files:
        differing = sorted(path for path in right.files if ending.files.get(path) != right.files[path])
        return f"ends with 0, but files differ: {differing}"
    return ""


def try_fault(place, command, template, before, right, kind, mode, number):
    """Returns what is wrong, or '', and whether the fault was delivered."""
    here = place.copy(template, f"{command.name}-{kind}-{mode}-{number}")
    try:
        ending = place.run(here, command.words, {"kind": kind, "at": number, "mode": mode})
        wrong = ""
        if mode != "kill":
            wrong = judge(command, kind, ending, right, before)
        if not wrong and command.writes and (ending.code or mode == "kill"):
            again = place.run(here, command.words)
            left = {path: contents for path, contents in again.files.items() if ".part-" not in path}
            if again.code != 0:
                wrong = f"cannot be run again: {again.code}, {again.errors[:1]}"
            elif left != right.files:
                wrong = "run again gives other files: " + ", ".join(
                    sorted(path for path in {*left, *right.files} if left.get(path) != right.files.get(path)))
        return wrong, ending.report.get("delivered", 1)
    finally:
        shutil.rmtree(here)


def choose(count, sample, seed):
    """The numbers of the calls that fail: all, or a sample drawn from a seed, with the first and the last call."""
    if sample == 0 or count <= sample:
        return list(range(1, count + 1))
    return sorted({1, count, *random.Random(seed).sample(range(1, count + 1), sample)})


def campaign(place, commands, kinds, modes, sample, seed, crew):
    number = failed = trials = 0
    for command in commands:
        template = place.prepare(command)
        before = place.ending(template, 0, b"", b"").files
        here = place.copy(template, command.name + "-right")
        right = place.run(here, command.words, {"kind": "write", "at": 0})
        if right.code != 0:
            raise SystemExit(f"{command.name} ends with {right.code} undisturbed: {right.errors}")
        for kind in kinds:
            for mode in modes:
                if kind == "allocate" and mode == "kill" or not right.report[kind]:
                    continue
                chosen = choose(right.report[kind], sample, f"{seed} {command.name} {kind} {mode}")
                results = list(crew.map(lambda k: try_fault(place, command, template, before, right, kind, mode, k),
                                        chosen))
                wrong = [(k, what) for k, (what, _) in zip(chosen, results) if what]
                number += 1
                trials += len(chosen)
                failed += bool(wrong)
                print(f"{'not ok' if wrong else 'ok'} {number} - {command.name}: {kind} {mode}, {len(chosen)} of "
                      f"{right.report[kind]} calls, {len(wrong)} wrong", flush=True)
                for k, what in wrong[:12]:
                    print(f"#   call {k}: {what}", flush=True)
    print(f"1..{number}")
    print(f"# {trials} faults, seed {seed}; {failed} of {number} lines failed", flush=True)
    return failed


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program", help="the program: build/src/cli/pulloff")
    parser.add_argument("shim", help="the library that injects the faults: build/tests/robust/libshim.so")
    parser.add_argument("--command", action="append", metavar="NAME", help="only these commands")
    parser.add_argument("--kind", action="append", choices=KINDS, help="only these kinds of faults")
    parser.add_argument("--mode", action="append", choices=MODES, help="one call fails, all later ones too, or a kill")
    parser.add_argument("--sample", type=int, default=0, metavar="N", help="calls of each command and kind (all)")
    parser.add_argument("--seed", type=int, default=11, help="seed of the sample (11)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="N", help="trials side by side (all cores)")
    return parser.parse_args()


def main():
    given = arguments()
    chosen = [command for command in COMMANDS if not given.command or command.name in given.command]
    if not chosen:
        sys.exit(f"no such command: expected some of {', '.join(command.name for command in COMMANDS)}")
    with tempfile.TemporaryDirectory(prefix="pulloff-robust-") as folder, \
            concurrent.futures.ThreadPoolExecutor(given.jobs) as crew:
        place = Place(os.path.abspath(given.program), os.path.abspath(given.shim), os.path.join(HERE, "data"), folder)
        sys.exit(1 if campaign(place, chosen, given.kind or KINDS, given.mode or MODES, given.sample, given.seed, crew)
                 else 0)


if __name__ == "__main__":
    main()
