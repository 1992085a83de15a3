"""Commands that differ only in the preload, and which of them have the same pull-off force.

The force is the depth of the deepest minimum of the load on the branch up to the preload (doc/guide.md), and never falls with the
preload. Commands with the same force at two preloads have it in between. A document also states the least preload with its
force."""

import math
import re

OPTION = re.compile(r" --preload(-load)? (\S+)")
MARGIN = 1e-3       # a preload this close to the least one of a force is run; the stated errors of the least one are far smaller
SHARED = re.compile(r"pull_off\.force|input\.(?!preload).*")    # what the documents of two such commands have in common


def scene_of(line):
    """(the command without its preload, whether the preload is a load, its value); None for another command."""
    found = OPTION.search(line)
    if not line.startswith("solve ") or not found:
        return None
    try:
        return line.replace(found[0], "", 1), bool(found[1]), float(found[2])
    except ValueError:
        return None


def scenes(paths):
    """The commands of each scene with a preload, by rising preload. `paths`: by command, the paths that are read from it."""
    made = {}
    for line, read in paths.items():
        if scene_of(line) and all(map(SHARED.fullmatch, read)):
            *scene, value = scene_of(line)
            made.setdefault(tuple(scene), []).append((value, line))
    return [[line for _, line in sorted(lines)] for lines in made.values()]


def by_approach(lines, document):
    """{command: one with the same force}, from the hardest preload down."""
    same, least, last = {}, math.inf, None
    for line in reversed(lines):
        if scene_of(line)[2] > least:
            same[line] = last
            continue
        made = document(line)
        stated = made["pull_off"]["preload"]["approach"] if made else None
        last, least = line, math.inf if stated is None else stated + MARGIN * max(1, abs(stated))
    return same


def by_load(lines, document):
    """{command: one with the same force}, by halving."""
    ends = [document(lines[0]), document(lines[-1])]
    if len(lines) < 3:
        return {}
    if all(ends) and ends[0]["pull_off"]["force"] == ends[1]["pull_off"]["force"]:
        return dict.fromkeys(lines[1:-1], lines[-1])
    middle = len(lines) // 2
    return by_load(lines[:middle + 1], document) | by_load(lines[middle:], document)


def same_force(lines, document):
    """{command: one with the same force} of the commands of one scene. `document` gives the document of a command, or None."""
    return (by_load if scene_of(lines[0])[1] else by_approach)(lines, document)
