#!/usr/bin/env python3
"""Runs the commands that the documents print and compares the output that they show.

Usage: documents.py PROGRAM SOURCE_TREE [--write]

A command with its output is a fenced block:

    ```console
    $ pulloff solve --tabor 1
    the output
    ```

A file that a page shows is written before the commands below it: ```python file=my/solver.py. The files of doc/examples are in the
folder `examples`.

`$ build/src/cli/pulloff` means the same, `$ python3 FILE` runs a file of the page with the Python module, and a backslash at
the end of a line continues the command. A line `...` stands for any number of lines of output. Output has to be the same to the last digit, on every machine, except:

- times: the seconds of JSON documents, numbers before ` s`, and those in a column `seconds`;
- numbers that an external solver computes (commands with --solver), which may differ by 1e-5 (relative);
- the folder in which the commands run is shown as /home/me;
- a command whose block shows no output is run only.

Numbers in the text are bound to commands by comments in the lines after a paragraph or a table: the output of the command
has each phrase, and the paragraph has the numbers of each phrase:

    <!-- pulloff solve --tabor 1: force 3.2e-11; 49 points -->

Commands in the manual page are lines that begin with `pulloff solve`, `follow` or `theory`. With --write the blocks whose output differs are replaced by the current
output; check the differences before you commit them. Exit status: 0 all commands succeed and all shown output is
correct, 1 otherwise.
"""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

from tally import Tally

BLOCK = re.compile(r"^```(console|\w+ file=(\S+))\n(.*?)^```$", re.M | re.S)
SHOWN_FOLDER = "/home/me"
COMMAND = re.compile(r"((?:build/src/cli/)?pulloff|python3) (.*)")
PYTHON = "/usr/bin/python3"  # which has NumPy
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?$")
BOUND = re.compile(r"<!-- pulloff (.*?): (.*?) -->")
OF_OTHERS = 1e-5  # what numbers of external solvers may differ by


def number(word):
    word = word.rstrip(",;:")
    return float(word) if NUMBER.match(word) else None


def alike_lines(shown, printed, seconds=None, tolerance=0.0):
    """Whether two lines agree. Given: `seconds`, the place of the word that is a time."""
    if re.match(r' *"seconds', shown) and re.match(r' *"seconds', printed):
        return True
    a, b = shown.split(), printed.split()
    times = {place for place, word in enumerate(a[1:]) if word.rstrip(",;") == "s"} | {seconds}

    def alike(place, one, other):
        if one == other:
            return True
        x, y = number(one), number(other)
        return x is not None and y is not None and (place in times or abs(x - y) <= tolerance * abs(y))

    return len(a) == len(b) and all(alike(place, *words) for place, words in enumerate(zip(a, b)))


def difference(shown, printed, tolerance):
    """What is wrong with the shown lines; None if nothing is."""
    place = 0
    skip = False
    seconds = None
    for line in shown:
        if "seconds" in line.split():
            seconds = line.split().index("seconds")
        if line.strip() == "...":
            skip = True
            continue
        while skip and place < len(printed) and not alike_lines(line, printed[place], seconds, tolerance):
            place += 1
        if place == len(printed):
            return f"not printed: {line}"
        if not alike_lines(line, printed[place], seconds, tolerance):
            return f"shown:   {line}\n  printed: {printed[place]}"
        place += 1
        skip = False
    return None if skip or place == len(printed) else f"not shown: {printed[place]}"


def split(text):
    """The commands of a block, each with the lines of output after it."""
    found = []
    for line in text.splitlines():
        if line.startswith("$ "):
            found.append([line, []])
        elif found and found[-1][0].endswith("\\"):
            found[-1][0] += "\n" + line
        elif found:
            found[-1][1].append(line)
        else:
            raise ValueError(f"a block that does not begin with a command: {line}")
    return found


class Tests(Tally):
    def __init__(self, program, root, folder, write):
        self.program, self.folder, self.write = program, folder, write
        library = pathlib.Path(program).parents[1] / "library/libpulloff.so.0"
        self.environment = dict(os.environ, PULLOFF_DATA=str(root), PULLOFF_LIBRARY=str(library), PYTHONPATH=str(root / "python"),
                                PYTHONDONTWRITEBYTECODE="1")

    def run(self, command):
        """The lines that a command line prints; None if it fails."""
        words = COMMAND.fullmatch(command.replace("\\\n", " "))
        if not words:
            self.tell(command, "not a command of pulloff, nor python3")
            return None
        program = PYTHON if words[1] == "python3" else self.program
        ended = subprocess.run([program, *shlex.split(words[2])], cwd=self.folder, env=self.environment,
                               capture_output=True, text=True)
        if ended.returncode:
            self.tell(command, f"exit status {ended.returncode}: {ended.stderr.strip()}")
            return None
        return ended.stdout.replace(os.path.realpath(self.folder), SHOWN_FOLDER).splitlines()

    def block(self, name, text):
        """Tests a block and returns it with the current output."""
        today = []
        for line, shown in split(text):
            printed = self.run(line.removeprefix("$ "))
            tolerance = OF_OTHERS if "--solver" in line else 0.0
            wrong = None if printed is None or not shown else difference(shown, printed, tolerance)
            if printed is not None:
                self.tell(f"{name}: {line}", wrong)
            keep = printed is None or wrong is None or "..." in map(str.strip, shown)
            if self.write and keep and wrong:
                print("  not written: a block with `...` is changed by hand")
            today += [line, *(shown if keep else printed)]
        return "\n".join(today) + "\n"

    def follow(self, name, kind, file, text):
        """Does what a block says, and returns it with the current output."""
        if kind == "console":
            return self.block(name, text)
        path = pathlib.Path(self.folder, file)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return text

    def bound(self, name, paragraph, command, phrases):
        """Tests the numbers of a paragraph that are bound to a command."""
        printed = self.run("pulloff " + command)
        text = " ".join(" ".join(printed or []).split())
        for phrase in phrases.split("; "):
            numbers = [word for word in phrase.replace(",", " ").split() if number(word) is not None]
            lacking = [word for word in numbers if not re.search(rf"(?<![\d.]){re.escape(word)}(?!\d)", paragraph)]
            self.tell(f"{name}: {phrase}", "the command prints otherwise" if phrase not in text else
                      f"not in the paragraph: {', '.join(lacking)}" if lacking or not numbers else None)

    def page(self, path, name):
        text = path.read_text()
        for paragraph in re.split(r"\n\n+", text):
            for command, phrases in BOUND.findall(paragraph):
                self.bound(name, BOUND.sub("", paragraph), command, phrases)
        renewed = BLOCK.sub(lambda found: f"```{found[1]}\n{self.follow(name, *found.groups())}```", text)
        if self.write and renewed != text:
            path.write_text(renewed)
            print(f"written: {name}")

    def manual(self, path):
        text = re.sub(r"\\\n +", " ", path.read_text()).replace("\\-", "-")
        commands = re.findall(r"^ *(pulloff (?:solve|follow|theory) -*[a-z].*)$", text, re.M)
        self.tell(f"{path.name} has commands", None if commands else "none found")
        for command in commands:
            if self.run(command) is not None:
                self.tell(command, None)


def main():
    program, root = os.path.realpath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    pages = [root / "README.md", *sorted(root.glob("doc/*.md")), root / "doc/examples/README.md", root / "cases/README.md",
             root / "reference/README.md", root / "reports/README.md"]
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(root / "doc/examples", pathlib.Path(folder, "examples"), ignore=shutil.ignore_patterns("pictures"))
        tests = Tests(program, root, folder, "--write" in sys.argv)
        for path in pages:
            tests.page(path, str(path.relative_to(root)))
        tests.manual(root / "src/cli/pulloff.1")
    return tests.end("" if tests.write else "; --write renews the blocks")


if __name__ == "__main__":
    sys.exit(main())
