#!/usr/bin/python3
"""Carries out the examples of doc/extending.md, the files NAME.recipe of this folder, in a copy of the source tree, and
runs their commands there.

    recipes.py BUILD                 all recipes; the copy is BUILD/recipes/tree and is removed at the end
    recipes.py BUILD --only law      only this recipe
    recipes.py BUILD --keep          keeps the copy

The blocks of a recipe:

    ```c new=PATH                a new file
    ```diff new=PATH from=OTHER  a new file: OTHER with edits
    ```diff file=PATH            edits of a file
    ```console                   commands with their output, compared as in the other documents (tests/cli/documents.py)

An edit is a group of lines: those that begin with - or a space stand in the file exactly once, and those with + or a
space take their place. A line @@ separates two edits. Each recipe must fit the unchanged tree; all are then applied to
one copy, built once, and their commands run. Exit status: 0 all succeed, 1 otherwise."""

import argparse
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
NAMES = ("law", "profile", "number", "check", "case", "figure") # in the order in which they are applied to one copy
sys.path.insert(0, str(ROOT / "tests" / "cli"))
import documents  # noqa: E402

BLOCK = re.compile(r"^```(\w+)((?: \w+=\S+)*)\n(.*?)^```$", re.M | re.S)


class Wrong(Exception):
    """A recipe that cannot be carried out, or whose command gives something else."""


def blocks_of(text):
    """The blocks of a recipe, each (kind, options, text)."""
    return [(kind, dict(word.split("=", 1) for word in options.split()), body) for kind, options, body in BLOCK.findall(text)]


def read(name):
    """The blocks of the recipe of this name."""
    return blocks_of((HERE / f"{name}.recipe").read_text(encoding="utf-8"))


def touched(blocks):
    """The files that a recipe changes, and the folders in which it makes files."""
    return [options.get("file") or os.path.dirname(options["new"]) for _, options, _ in blocks if {"new", "file"} & set(options)]


def edited(text, edits, name):
    """The text of a file with edits."""
    for edit in re.split(r"^@@\n", edits, flags=re.M):
        lines = edit.splitlines(keepends=True)
        strange = [line for line in lines if line[0] not in " -+\n"]
        old, new = ([line[1:] for line in lines if line[0] in marks] for marks in (" -", " +"))
        present = text.splitlines(keepends=True)
        places = [k for k in range(len(present)) if present[k:k + len(old)] == old]
        if strange or not old or old == new or len(places) != 1:
            raise Wrong(f"{name}: expected these lines once, found them {len(places)} times:\n{''.join(old) or edit}")
        present[places[0]:places[0] + len(old)] = new
        text = "".join(present)
    return text


def carried_out(blocks, files):
    """Applies the blocks to `files` (path -> text; files that are not in it are those of the source tree)."""
    def text_of(path):
        return files[path] if path in files else (ROOT / path).read_text(encoding="utf-8")

    for kind, options, body in blocks:
        path = options.get("new", options.get("file"))
        if path is None:
            continue
        if "new" in options and (path in files or (ROOT / path).exists()):
            raise Wrong(f"{path}: is not new")
        files[path] = edited(text_of(options.get("from", path)), body, path) if kind == "diff" else body
    return files


def left_out(folder, names):
    """What the copy does not need: build folders, hidden files and caches."""
    return [name for name in names if name.startswith(".") or name == "__pycache__"
            or os.path.exists(os.path.join(folder, name, "meson-private"))]


class Copy:
    """A copy of the tree, built. What the build folder of the tree has compiled is compiled again only if a recipe changes it: ninja
    sees it by the times of the files and by the commands, which name them relative to the build folder."""

    def __init__(self, built):
        self.built = built
        self.tree = built / "recipes" / "tree"
        self.build = self.tree / "build"

    def make(self, files):
        shutil.copytree(ROOT, self.tree, ignore=left_out)
        if (self.built / ".ninja_deps").exists():
            shutil.copytree(self.built / "src", self.build / "src")
            for name in (".ninja_log", ".ninja_deps"):
                shutil.copy2(self.built / name, self.build)
        for path, text in files.items():
            (self.tree / path).parent.mkdir(parents=True, exist_ok=True)
            (self.tree / path).write_text(text, encoding="utf-8")
        self.run(["meson", "setup", "build"])
        self.ninja("src/cli/pulloff")

    def run(self, words):
        """What a command prints."""
        ended = subprocess.run(words, cwd=self.tree, capture_output=True, text=True, check=False,
                               env=dict(os.environ, PULLOFF_DATA=str(self.tree)))
        if ended.returncode:
            raise Wrong(f"{shlex.join(words)}: exit status {ended.returncode}\n{ended.stdout}{ended.stderr}")
        return ended.stdout

    def ninja(self, target):
        self.run(["ninja", "-C", "build", target])

    def command(self, line):
        """The lines that a command of a document prints."""
        words = shlex.split(line)
        if words[:2] == ["meson", "test"]:
            tests = json.loads(self.run(["meson", "introspect", "--tests", "build"]))
            for program in {test["cmd"][0] for test in tests if test["name"] == words[-1]}:
                if program.startswith(str(self.build)):
                    self.ninja(os.path.relpath(program, self.build))
            words.insert(2, "--no-rebuild")
        elif words[0] == "python3":
            words[0] = sys.executable
        elif words[0] == "pulloff":
            words[0] = str(self.build / "src" / "cli" / "pulloff")
        return self.run(words).splitlines()


def failures(copy, blocks):
    """What is wrong with the commands of a recipe."""
    for kind, _, body in blocks:
        for line, shown in documents.split(body) if kind == "console" else []:
            try:
                printed = copy.command(line.removeprefix("$ "))
                wrong = documents.difference(shown, printed, 0.0) if shown else None
            except Wrong as why:
                wrong = str(why)
            if wrong:
                yield f"{line}\n  {wrong}"


def example(copy):
    """What is wrong with the script of doc/examples that draws the pull-off under the law of the recipe, in this copy."""
    place = copy.tree / "example"
    (place / "own").mkdir(parents=True)
    (place / "own" / "recipes").symlink_to(copy.tree.parent)
    try:
        copy.run(["sh", "-c", "cd example && exec sh ../doc/examples/own_law.sh own_law.png"])
    except Wrong as why:
        return str(why)
    return None if (place / "own_law.png").stat().st_size > 4000 else "the picture is empty"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("build", type=pathlib.Path, help="the build folder")
    parser.add_argument("--only", choices=NAMES, help="only this recipe")
    parser.add_argument("--keep", action="store_true", help="keep the copy")
    given = parser.parse_args()
    recipes = [(name, read(name)) for name in NAMES if given.only in (None, name)]
    copy, files, failed = Copy(given.build.resolve()), {}, False
    try:
        for name, blocks in recipes:
            carried_out(blocks, {})
            carried_out(blocks, files)
        shutil.rmtree(copy.tree, ignore_errors=True)
        copy.make(files)
        for name, blocks in recipes:
            wrong = list(failures(copy, blocks))
            if "law" in name and not given.keep:    # with --keep this script is run by that of the example
                wrong += [text for text in [example(copy)] if text]
            print("\n".join([f"{'not ok' if wrong else 'ok'}: {name}", *wrong]))
            failed = failed or bool(wrong)
    except Wrong as why:
        print(why)
        failed = True
    if not given.keep:
        shutil.rmtree(copy.tree, ignore_errors=True)
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
