"""Runs `pulloff solve --json` and keeps every solution in a journal, so that a campaign can be continued."""

import concurrent.futures
import hashlib
import json
import os
import signal
import subprocess
import sys
import threading
import time

SLACK = 60       # a solve is stopped after twice the time limit plus this, in seconds of processor time


def number(value):
    """A number in the form of the command line."""
    return value if isinstance(value, str) else f"{value:.17g}" if float(f"{value:g}") != value else f"{value:g}"


def words(scene, tolerance, limit=None):
    """The arguments of a solve. Without a limit they are those that are printed."""
    flags = dict(scene, tolerance=tolerance, **({"time-limit": limit} if limit else {}))
    return ["solve", *(word for name, value in flags.items() for one in (value if isinstance(value, list) else [value])
                       for word in (f"--{name}", number(one)))]


def command(scene, tolerance):
    return " ".join(["pulloff", *words(scene, tolerance)])


def solve(program, scene, tolerance, limit):
    """The document of one solve. If the program prints none, the status is `refused` (exit code 2) or `crashed`, and the reason is
    stated."""
    most = int(2 * limit) + SLACK
    done = subprocess.run(["prlimit", f"--cpu={most}", program, *words(scene, tolerance, limit), "--json"],
                          capture_output=True, check=False, text=True)
    try:
        return json.loads(done.stdout)
    except ValueError:
        if done.returncode == -signal.SIGXCPU:
            return {"status": "crashed", "reason": f"not ended after {most} s, with a time limit of {limit:g} s"}
        last = done.stderr.strip().splitlines()[-1:] or ["no message"]
        return {"status": "refused" if done.returncode == 2 else "crashed", "reason": f"exit code {done.returncode}: {last[0]}"}


class Journal:
    """Solutions by program, scene and tolerance, one on each line."""

    def __init__(self, path, program, limit, fresh=False):
        with open(program, "rb") as stream:
            self.digest = hashlib.sha256(stream.read()).hexdigest()[:16]
        self.program, self.limit, self.lock = program, limit, threading.Lock()
        os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
        self.kept = {} if fresh else self.read(path)
        self.stream = open(path, "w" if fresh else "a", encoding="utf-8")  # pylint: disable=consider-using-with
        if not fresh and os.path.getsize(path) and not self.whole:
            self.stream.write("\n")                     # an incomplete last line stays a separate line

    def read(self, path):
        kept, self.whole = {}, True
        if os.path.exists(path):
            with open(path, encoding="utf-8") as stream:
                for line in stream:
                    self.whole = line.endswith("\n")
                    try:
                        entry = json.loads(line)
                    except ValueError:
                        continue
                    kept[entry["key"]] = entry["solution"]
        return kept

    def key(self, scene, tolerance):
        return " ".join([self.digest, *words(scene, tolerance, self.limit)])

    def has(self, scene, tolerance):
        return self.key(scene, tolerance) in self.kept

    def solution(self, scene, tolerance):
        """Solves the scene unless the journal has its solution."""
        key = self.key(scene, tolerance)
        if key not in self.kept:
            found = solve(self.program, scene, tolerance, self.limit)
            with self.lock:
                self.kept[key] = found
                self.stream.write(json.dumps({"key": key, "solution": found}) + "\n")
                self.stream.flush()
        return self.kept[key]

    def close(self):
        self.stream.close()


def run(tasks, journal, wanted):
    """Every task solves the scenes that are not in the journal."""
    begin, done = time.monotonic(), 0
    pool = concurrent.futures.ThreadPoolExecutor(wanted.jobs or len(os.sched_getaffinity(0)))
    try:
        for future in concurrent.futures.as_completed([pool.submit(task.solve, journal, wanted) for task in tasks]):
            future.result()
            done += 1
            if not wanted.quiet:
                print(f"{done}/{len(tasks)} scenes, {time.monotonic() - begin:.0f} s elapsed", file=sys.stderr)
    finally:
        pool.shutdown(cancel_futures=True)


def campaign(name, journal_name, tasks, wanted, report):
    """Solves all tasks, reports, and returns the exit code."""
    program = wanted.program or os.path.join(wanted.build, "src", "cli", "pulloff")
    path = wanted.journal or os.path.join(wanted.build, journal_name)
    try:
        journal = Journal(path, program, wanted.time_limit, wanted.fresh)
        try:
            run(tasks, journal, wanted)
        finally:
            journal.close()
    except OSError as error:
        print(f"{name}: {error}", file=sys.stderr)
        return 4
    except KeyboardInterrupt:
        print(f"{name}: interrupted; what was solved is kept in {path}", file=sys.stderr)
        return 130
    return report(tasks, wanted)


def tell_crashed(name, document, text):
    """Prints a solve without a document, and its command."""
    print(f"crashed: {name}: {document['reason']}\n  {text}")


def exit_code(violated, compared, crashed):
    """Prints how many scenes have a violation, and returns the exit code of a campaign."""
    print(f"{violated} of {compared} scenes with a violation")
    if violated or crashed:
        return 1
    return 0 if compared else 3
