#!/usr/bin/python3
"""Kills runs of the program at random moments, by SIGKILL and SIGTERM in turn, and runs them again.

After each kill every file must be complete (a journal may end in half a line, a record must be that of the finished
run). The run that is continued to its end must give the same as an undisturbed one, except for times. Prints TAP
(README.md)."""

import argparse
import concurrent.futures
import json
import os
import random
import shutil
import signal
import sys
import tempfile
import time

from trial import Command, Place

HERE = os.path.dirname(os.path.abspath(__file__))
RUN = Command("run", ("run", "many", "--jobs", "2", "--output", "run"), writes=True)
MOST_KILLS = 60  # of one run, in case it makes no progress


def torn(files, right):
    """A file that a killed run must not leave; '' if there is none."""
    for path, contents in files.items():
        if ".part-" in path or path.startswith("data/") or path.endswith("points.jsonl"):
            continue
        if contents != right.files.get(path):
            return f"{path} is torn"
    return ""


def points_kept(here):
    """The number of complete points in the journal."""
    path = os.path.join(here, "run/many/points.jsonl")
    if not os.path.exists(path):
        return 0
    with open(path, "rb") as file:
        lines = file.read().split(b"\n")[:-1]
    kept = 0
    for line in lines:
        try:
            kept += "key" in json.loads(line)
        except ValueError:
            pass
    return kept


def kill_once(place, here, number, after, right):
    """Starts the run and kills it after `after` seconds. Returns whether it was killed, and what is wrong."""
    before = points_kept(here)
    process = place.start(here, RUN.words, None)
    time.sleep(after)
    process.send_signal(number)
    output, errors = process.communicate(timeout=place.seconds)
    ending = place.ending(here, process.returncode, output, errors)
    if ending.code == 0:
        return False, ""
    expected = (-number,) if number == signal.SIGKILL else (-number, 130)  # killed at once, or ended by itself
    if ending.code not in expected:
        return True, f"ends with {ending.code} after signal {number}: {ending.errors}"
    if points_kept(here) < before and not os.path.exists(os.path.join(here, "run/many/record.json")):
        return True, f"kept {points_kept(here)} points of {before}"
    return True, torn(ending.files, right)


def one_run(place, template, right, seed, seconds):
    """One run, killed again and again until it is finished. Returns how often it was killed, and what is wrong."""
    chance = random.Random(seed)
    here = place.copy(template, f"run-{seed}")
    kills = 0
    try:
        for _ in range(MOST_KILLS):
            number = chance.choice((signal.SIGKILL, signal.SIGTERM))
            killed, wrong = kill_once(place, here, number, chance.uniform(0.0, 0.6 * seconds), right)
            kills += killed
            if wrong:
                return kills, wrong
            if not killed:
                break
        ending = place.run(here, RUN.words)
        left = {path: contents for path, contents in ending.files.items() if ".part-" not in path}
        if ending.code != 0:
            return kills, f"cannot be continued: {ending.code}, {ending.errors}"
        if left != right.files:
            return kills, "files differ: " + ", ".join(
                sorted(path for path in {*left, *right.files} if left.get(path) != right.files.get(path)))
        return kills, ""
    finally:
        shutil.rmtree(here)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program", help="the program: build/src/cli/pulloff")
    parser.add_argument("--kills", type=int, default=200, metavar="N", help="least number of kills (200)")
    parser.add_argument("--seed", type=int, default=11, help="seed of the moments and signals (11)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="N", help="runs side by side (all cores)")
    return parser.parse_args()


def main():
    given = arguments()
    with tempfile.TemporaryDirectory(prefix="pulloff-kills-") as folder:
        place = Place(os.path.abspath(given.program), "", os.path.join(HERE, "data"), folder)
        template = place.prepare(RUN)
        here = place.copy(template, "right")
        begin = time.monotonic()
        right = place.run(here, RUN.words)
        seconds = time.monotonic() - begin
        if right.code != 0:
            sys.exit(f"an undisturbed run ends with {right.code}: {right.errors}")
        kills = runs = failed = 0
        while kills < given.kills and not failed:
            with concurrent.futures.ThreadPoolExecutor(given.jobs) as crew:
                results = list(crew.map(lambda number: one_run(place, template, right, number, seconds),
                                        range(given.seed + runs, given.seed + runs + given.jobs)))
            for count, wrong in results:
                runs += 1
                kills += count
                failed += bool(wrong)
                print(f"{'not ok' if wrong else 'ok'} {runs} - killed {count} times{': ' if wrong else ''}{wrong}",
                      flush=True)
        print(f"1..{runs}\n# {kills} kills in {runs} runs of {seconds:.2f} s, seed {given.seed}; {failed} went wrong")
        sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
