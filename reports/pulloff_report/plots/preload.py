"""How hard the spheres of a figure were pressed, and what other preloads give."""

import math

from ..words import plain, value_of
from . import twice

USUAL_LOAD = 1.0   # in πwR: the preload of a case that gives none
SEEN = 0.01        # a pull-off of a harder preload that is larger by less is not told apart


def words(approach, load):
    """"pressed to Δ† = 4" and the like."""
    parts = [f"to Δ† = {plain(approach)}"] if approach is not None else []
    parts += [f"to a load of {plain(load)} πwR"] if load is not None else []
    return "pressed " + (" or ".join(parts) + (", whichever comes first" if len(parts) == 2 else "")
                         if parts else f"to a load of {plain(USUAL_LOAD)} πwR")


def declared(case):
    """The one preload of all scenes of a case, in words."""
    scene = case.points[0]["input"]
    return words(scene.get("preload"), scene.get("preload_load"))


def greatest(case, keys):
    """Key values -> (greatest force of all preloads, whether no harder one gives more) of the solved points."""
    found = {}
    for point in case.points if case else []:
        known = point.get("pull_off_any")
        if point["status"] == "ok" and known:
            found[tuple(value_of(point, key) for key in keys)] = (known["force"], known["complete"])
    return found


def larger(case, keys):
    """Of a case and its case at any preload: key values -> force of those that a harder preload makes larger to be seen."""
    stated = {key: value[0] for key, value in twice.rows(case, keys).items()}
    return {key: force for key, (force, _) in greatest(case.any_preload, keys).items()
            if not (twice.match(stated, key) or math.inf) * (1 + SEEN) > force}


def caption(case, keys, sign):
    """What the second layer of a figure is, in sentences; `sign` says what it is drawn as."""
    text = (f" The paper does not state how hard the sphere was pressed; here all scenes are {declared(case)}.")
    if case.any_preload is None:
        return text + f" This run holds no record of {case.name}_any, so other preloads are not shown."
    known = greatest(case.any_preload, keys)
    open_ends = sum(not complete for _, complete in known.values())
    text += (f" {sign}: the greatest force that any preload gives, where it is larger by more than {SEEN:.0%} "
             f"({len(larger(case, keys))} of {len(case.any_preload.points)} scenes looked at).")
    if open_ends:
        text += f" In {open_ends} of the scenes looked at, preloads beyond a load of 100 πwR may give still more."
    return text + " Steep waves of soft spheres, which it takes minutes to press so hard, were not looked at."
