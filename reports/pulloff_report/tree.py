"""What a report was made from: the commit, the files of the tree, the libraries of the program."""

import hashlib
import os
import re
import subprocess

COMMIT = ".commit"       # in an archive (reports/archive.py): the commit of its sources, which have no history
SKIPPED = ("build",)     # folders of a tree without a history that are no sources: what is made in it, and results of an archive
RESULTS = "results"      # the folder of an archive that holds the report and the records
MADE = re.compile(r"(^|/)__pycache__/|\.pyc$")
DIGITS = 12              # of a checksum that are shown


def git(tree, *words):
    """The output of a git command in a tree, or None without git or a history."""
    try:
        done = subprocess.run(["git", "-C", tree, *words], capture_output=True, check=False)
    except OSError:
        return None
    return done.stdout.decode("utf-8", "surrogateescape") if done.returncode == 0 else None


def files(tree):
    """The sources of a tree, sorted: those in its history, or, in an archive, all that were not made since. Empty in another folder."""
    if os.path.exists(os.path.join(tree, ".git")):
        listed = (git(tree, "ls-files", "-z") or "").split("\0")
        return sorted(name for name in listed if name and os.path.isfile(os.path.join(tree, name)))
    if not os.path.exists(os.path.join(tree, COMMIT)):
        return []
    found = []
    for place, inner, names in os.walk(tree):
        if place == tree:
            inner[:] = [name for name in inner if not name.startswith(SKIPPED) and name != RESULTS]
        found += [os.path.relpath(os.path.join(place, name), tree) for name in names]
    return sorted(name for name in found if name != COMMIT and not MADE.search(name))


def digest(path):
    with open(path, "rb") as stream:
        return hashlib.sha256(stream.read()).hexdigest()


def checksum(tree, names):
    """sha256 of the names and the contents of files."""
    return hashlib.sha256("".join(f"{digest(os.path.join(tree, name))}  {name}\n" for name in names).encode()).hexdigest()


def commit(tree):
    """The commit of a tree, with a remark if files differ from it; None for a tree without a history."""
    if os.path.exists(os.path.join(tree, ".git")):
        head = (git(tree, "rev-parse", "HEAD") or "").strip()
        changed = git(tree, "status", "--porcelain", "--untracked-files=no")
        return head and head + (" with changes" if changed else "")
    try:
        with open(os.path.join(tree, COMMIT), encoding="ascii") as stream:
            return stream.read().strip()
    except OSError:
        return None


def libraries(program):
    """(name, sha256) of the numerical libraries that a program loads; nothing without the program or ldd."""
    try:
        said = subprocess.run(["ldd", program], capture_output=True, text=True, check=False).stdout
    except OSError:
        return []
    found = re.findall(r"(lib(?:m|gsl|openblas|lapacke)\b[^ ]*) => (/\S+)", said)
    return sorted((name, digest(path)) for name, path in found if os.path.isfile(path))


def identity(tree, program=None):
    """(label, text) of all that identifies the program of a report, shortened; empty for an installed program."""
    names = files(tree)
    rows = []
    if names:
        known, _, remark = (commit(tree) or "unknown").partition(" ")
        rows = [("commit", known[:DIGITS] + (f" {remark}" if remark else "")),
                (f"tree of {len(names)} files", checksum(tree, names)[:DIGITS])]
    return rows + [(name, value[:DIGITS]) for name, value in (libraries(program) if program else [])]


def words(rows):
    return ", ".join(f"{label} {text}" for label, text in rows)
