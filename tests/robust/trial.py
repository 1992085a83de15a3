"""One trial: a command that runs in a separate folder, with or without a fault, and the files that it leaves there."""

import dataclasses
import json
import os
import re
import shutil
import subprocess

# Values that always differ between runs: times, and the machine. Also the keys of stored results: they depend on a
# checksum of the program, so they change if the program cannot read its own file, and points are solved again.
TIMES = {"seconds", "seconds_all", "processor_seconds_all", "date", "jobs", "checksum", "key", "solve_key", "system", "processor"}
PROGRESS = re.compile(r"^(\d+/\d+ .* elapsed.*|\S+: \d+.* points, \d+ checks: .*)$")


@dataclasses.dataclass(frozen=True)
class Command:
    """A command line, and the commands that must run before it."""

    name: str
    words: tuple
    before: tuple = ()  # command lines that create its input
    writes: bool = False  # whether it writes files; if so, it is run again after a fault


@dataclasses.dataclass
class Ending:
    code: int
    output: str
    errors: list  # lines of standard error without those of the progress
    files: dict  # path: contents without times
    report: dict  # the counts of the shim


def without_times(value):
    if isinstance(value, dict):
        return {key: without_times(item) for key, item in value.items() if key not in TIMES}
    if isinstance(value, list):
        return [without_times(item) for item in value]
    return value


def comparable(path, data):
    """The contents of a file or an output without times; the bytes if it is not a complete document."""
    try:
        text = data.decode()
        if path.endswith(".jsonl"):
            return sorted((json.dumps(without_times(json.loads(line))) for line in text.splitlines()), key=str)
        if path.endswith(".json") or text.startswith("{"):
            return without_times(json.loads(text))
        text = re.sub(r'time="[0-9.]+"', "", text)
        text = re.sub(r"^(\S+(?: +\d+){3}) +[0-9.]+", r"\1", text, flags=re.MULTILINE)  # a row of verify's table
        return re.sub(r", [0-9.e-]+ s$", "", text, flags=re.MULTILINE)
    except (UnicodeDecodeError, json.JSONDecodeError):
        return data


def files_below(folder):
    found = {}
    for here, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(here, name)
            with open(path, "rb") as file:
                found[os.path.relpath(path, folder)] = comparable(name, file.read())
    return found


def read_report(path):
    counted = {"kept": {}}
    if os.path.exists(path):
        with open(path, encoding="ascii") as file:
            for line in file:
                word, *rest = line.split()
                if word == "count":
                    counted[rest[0]] = int(rest[1])
                elif word == "kept":
                    counted["kept"][rest[0]] = counted["kept"].get(rest[0], 0) + 1
                else:
                    counted[word] = int(rest[0])
        os.remove(path)
    return counted


class Place:
    """The program, the shim and the folder of the trials."""

    def __init__(self, program, shim, data, folder, seconds=120):
        self.program, self.shim, self.data, self.folder, self.seconds = program, shim, data, folder, seconds

    def environment(self, here, orders):
        names = {**os.environ, "PULLOFF_DATA": os.path.join(here, "data"), "PULLOFF_PYTHON": "/usr/bin/python3",
                 "LC_ALL": "C.UTF-8", "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
        if orders is not None:
            names.update(LD_PRELOAD=self.shim, FAULT_REPORT=os.path.join(self.folder, os.path.basename(here) + ".counts"),
                         **{"FAULT_" + key.upper(): str(value) for key, value in orders.items()})
        return names

    def start(self, here, words, orders, **how):
        return subprocess.Popen([self.program, *words], cwd=here, env=self.environment(here, orders),
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, **how)

    def run(self, here, words, orders=None, **how):
        """Runs a command to its end. The exit code is None if it had to be stopped."""
        process = self.start(here, words, orders, **how)
        try:
            output, errors = process.communicate(timeout=self.seconds)
            code = process.returncode
        except subprocess.TimeoutExpired:
            process.kill()
            output, errors = process.communicate()
            code = None
        return self.ending(here, code, output, errors)

    def ending(self, here, code, output, errors):
        lines = [line for line in errors.decode(errors="replace").splitlines() if not PROGRESS.match(line)]
        report = read_report(os.path.join(self.folder, os.path.basename(here) + ".counts"))
        return Ending(code, comparable("", output), lines, files_below(here), report)

    def prepare(self, command):
        """Creates a folder with the input of a command."""
        here = os.path.join(self.folder, command.name + "-before")
        os.makedirs(here)
        shutil.copytree(self.data, os.path.join(here, "data"))
        for words in command.before:
            ending = self.run(here, words)
            if ending.code != 0:
                raise SystemExit(f"{command.name}: pulloff {' '.join(words)} ends with {ending.code}: {ending.errors}")
        return here

    def copy(self, template, name):
        here = os.path.join(self.folder, name)
        shutil.copytree(template, here)
        return here
