#!/usr/bin/python3
"""Kills the program at random moments while an external solver answers: no answer that was written is lost.

    killed.py PROGRAM [ROUNDS [SEED]]             the test
    killed.py --answer REQUEST RESPONSE           the solver

Each answer of the solver is a number that no other answer has. After each kill the complete lines in the journal and in
the responses are read. The record of a run that is not killed must have the first number that was ever seen for each
point: it was neither lost nor solved again. The program is killed with KILL or, in one of four rounds, interrupted
with INT. ROUNDS is 12 by default; a round takes about a second.
"""

import glob
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ME = os.path.abspath(__file__)
POINTS = 300

MANIFEST = """
protocol: pulloff-ask/1
solver: stamped
command: [/usr/bin/python3, '{me}', --answer, '{{request}}', '{{response}}']
can:
  scene: [{{key: tabor}}, {{key: radius}}, {{key: outer_radius}}]
  quantities: [pull_off_force]
  unstable: true
"""

CASE = f"""
name: many
title: Many spheres
suites: [own]
scene: {{radius: 100, outer_radius: inf, scheme: panel}}
sweep: [{{key: tabor, from: 0.1, to: 3, count: {POINTS}}}]
want: [pull_off]
checks: [{{quantity: pull_off_force, reference: pin, tolerance: 1, kind: abs, because: b}}]
"""


def answer(request, response):
    with open(request, encoding="utf-8") as stream:
        points = json.load(stream)["points"]
    pause = 10 / POINTS
    with open(response, "w", encoding="utf-8") as stream:
        for point in points:
            time.sleep(random.expovariate(1 / pause))
            stamp = float(time.time_ns() % 10**15)
            print(json.dumps({"id": point["id"], "status": "ok", "pull_off": {"force": stamp}}), file=stream, flush=True)


def complete_lines(path):
    try:
        with open(path, encoding="utf-8") as stream:
            return [json.loads(line) for line in stream if line.endswith("\n")]
    except FileNotFoundError:
        return []


def written(folder):
    """The numbers in the responses and in the journal: (point, number)."""
    for path in glob.glob(f"{folder}/ask-*/response.jsonl"):
        yield from ((found["id"], found["pull_off"]["force"]) for found in complete_lines(path))
    for entry in complete_lines(f"{folder}/points.jsonl"):
        yield entry["point"]["id"], entry["point"]["pull_off"]["force"]


def living(folder):
    """Whether a process works in the folder of this test or below it: a solver, or a child of the program that was killed
    before it became one, which still holds the lock of its folder."""
    for path in glob.glob("/proc/[0-9]*/cwd"):
        try:
            if path != f"/proc/{os.getpid()}/cwd" and (os.readlink(path) + "/").startswith(folder + "/"):
                return True
        except OSError:
            pass
    return False


class Test:
    def __init__(self, program, seed):
        self.program, self.chance = program, random.Random(seed)
        self.first = {}     # of the present record: the first number that was seen for each point
        self.kills = self.written = self.records = 0
        self.wrong = []

    def start(self):
        return subprocess.Popen([self.program, "run", "many.yaml", "--solver", "stamped.yaml", "--output", "run", "--jobs",
                                 str(self.chance.choice([1, 2, 3]))], stderr=subprocess.PIPE, text=True)

    def kill(self, results):
        run = self.start()
        time.sleep(self.chance.uniform(0.05, 1.5))
        run.send_signal(self.chance.choice([signal.SIGKILL] * 3 + [signal.SIGINT]))
        run.communicate()
        if run.returncode == 0:     # it had ended before
            self.compare(results)
            return
        self.kills += 1
        while living(os.getcwd()):
            time.sleep(0.01)
        for point, number in written(results):
            self.first.setdefault(point, number)

    def compare(self, results):
        """The record of a run that was not killed. A new one is begun after it."""
        record = json.loads(pathlib.Path(results, "record.json").read_text())
        final = {point["id"]: point["pull_off"]["force"] for point in record["points"]}
        self.wrong += [f"the answer to point {point} is lost" for point, number in self.first.items()
                       if final[point] != number]
        self.wrong += [f"left behind: {path}" for path in glob.glob(f"{results}/ask-*/response.jsonl")]
        self.written += len(self.first)
        self.records += 1
        self.first = {}
        shutil.rmtree(results)


def main(program, rounds, seed):
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        pathlib.Path("stamped.yaml").write_text(MANIFEST.format(me=ME))
        pathlib.Path("many.yaml").write_text(CASE)
        test = Test(program, seed)
        results = "run/solvers/stamped/many"
        for _ in range(rounds):
            test.kill(results)
        run = test.start()
        message = run.communicate()[1]
        if run.returncode:
            test.wrong.append(f"the last run fails: {message}")
        else:
            test.compare(results)
        os.chdir("/")
    if not test.written:
        test.wrong.append("no answer was written before a run was killed")
    print(f"killed {test.kills} times, {test.records} records; {test.written} answers were written before a kill; "
          f"{len(test.wrong)} failures")
    for text in test.wrong[:10]:
        print(f"FAILED: {text}")
    return len(test.wrong) > 0


if __name__ == "__main__":
    if sys.argv[1] == "--answer":
        answer(*sys.argv[2:])
    else:
        numbers = [int(word) for word in sys.argv[2:]]
        sys.exit(main(os.path.abspath(sys.argv[1]), *(numbers + [12, 0][len(numbers):])))
