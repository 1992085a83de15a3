"""Commands that differ only in the preload, and the pull-off forces that the branch of one of them gives for the others.

The force is the depth of the deepest minimum of the load on the branch up to the preload (doc/guide.md), and the branch up to a
preload is a part of the branch up to a harder one."""

import math
import re

OPTION = re.compile(r" --preload(-load)? (\S+)")
MARGIN = 1e-3       # a preload this close to the least one of a force is run; the stated errors of the least one are far smaller
SHARED = re.compile(r"pull_off\.force|input\.(?!preload).*")    # what is read off the branch of another command


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
    """For each scene with a preload, its commands of which more is read than SHARED, and the others: approaches, then loads, each
    from the hardest down. `paths`: by command, the paths that are read from it."""
    made = {}
    for line in sorted(filter(scene_of, paths), key=lambda line: (scene_of(line)[1], -scene_of(line)[2])):
        run, others = made.setdefault(scene_of(line)[0], ([], []))
        (others if all(map(SHARED.fullmatch, paths[line])) else run).append(line)
    return list(made.values())


def walk(document, key):
    """(greatest approach or load so far, None or a minimum of the load) at each point of a branch where one of them may change."""
    tops = [(point["position"], point[key], None) for point in document["extrema" if key == "load" else "folds"]
            if point["kind"] == ("maximum" if key == "load" else "jump_in")]
    minima = [(point["position"], point[key], point) for point in document["extrema"] if point["kind"] == "minimum"]
    top = -math.inf
    for _, value, minimum in sorted(tops + minima, key=lambda part: part[0]):
        top = max(top, value)
        yield top, minimum


def force_at(document, of_load, preload):
    """The pull-off force for a preload less hard than that of the document; None where the document does not decide it: the
    preload is not reached, or it is about the least one with a force, or the force has no stated error."""
    key = "load" if of_load else "approach"
    margin = MARGIN * max(1, abs(preload))
    force, error, greatest, deepest = 0.0, None, document["ended"][key], 0.0
    for top, minimum in walk(document, key):
        greatest = max(greatest, top)
        if not minimum or -minimum["load"] <= deepest:
            continue
        deepest = -minimum["load"]
        if abs(top - preload) < margin:
            return None
        if top < preload:
            force, error = deepest, minimum["load_error_estimate"]
    is_whole = deepest == document["pull_off"]["force"] and preload + margin < greatest
    return force if is_whole and error is not None else None


def read_off(line, documents):
    """What is SHARED of the document of a command, from those of harder preloads; None if they do not decide it."""
    _, of_load, preload = scene_of(line)
    for made in documents:
        force = force_at(made, of_load, preload)
        if force is not None:
            return {"input": {key: value for key, value in made["input"].items() if not key.startswith("preload")},
                    "pull_off": {"force": force}}
    return None


def share(run, others, document):
    """{command: what is SHARED of its document} of the commands of one scene that are not run, as scenes has them. `document` gives
    the document of a command, or None."""
    documents, shared = [made for made in map(document, run) if made], {}
    for line in others:
        found = read_off(line, documents)
        if found:
            shared[line] = found
        else:
            documents += filter(None, [document(line)])
    return shared
