"""The preload of the spheres of a figure, and the forces at other preloads."""

import math

from ..words import plain, value_of
from . import twice

USUAL_LOAD = 1.0   # in πwR: the preload of a case that states none
SEEN = 0.01        # relative difference from which a larger force at a harder preload is drawn


def words(approach, load):
    """"pressed to Δ† = 4" and the like."""
    parts = [f"to Δ† = {plain(approach)}"] if approach is not None else []
    parts += [f"to a load of {plain(load)} πwR"] if load is not None else []
    return "pressed " + (" or ".join(parts) + (", whichever comes first" if len(parts) == 2 else "")
                         if parts else f"to a load of {plain(USUAL_LOAD)} πwR")


def declared(case):
    """The preload of a case, which is the same for all its scenes, in words."""
    scene = case.points[0]["input"]
    return words(scene.get("preload"), scene.get("preload_load"))


def greatest(case, keys):
    """Key values -> (largest force at any preload, whether it is known that no harder preload gives more)."""
    found = {}
    for point in case.points if case else []:
        known = point.get("pull_off_any")
        if point["status"] == "ok" and known:
            found[tuple(value_of(point, key) for key in keys)] = (known["force"], known["complete"])
    return found


def larger(case, keys):
    """Key values -> force at any preload, for the scenes where it is larger by more than SEEN."""
    stated = {key: value[0] for key, value in twice.rows(case, keys).items()}
    return {key: force for key, (force, _) in greatest(case.any_preload, keys).items()
            if not (twice.match(stated, key) or math.inf) * (1 + SEEN) > force}


def caption(case, keys, sign):
    """Sentences on the preload and on the markers for other preloads; `sign` names these markers."""
    text = (f" The paper does not state the preload; here all spheres are {declared(case)}.")
    if case.any_preload is None:
        return text + f" This run has no record of {case.name}_any, so other preloads are not drawn."
    known = greatest(case.any_preload, keys)
    open_ends = sum(not complete for _, complete in known.values())
    drawn, scenes = len(larger(case, keys)), len(case.any_preload.points)
    text += (f" {sign}: the largest force at any preload, where it is larger by more than {SEEN:.0%} ({drawn} of {scenes} scenes "
             "computed)." if drawn else f" No preload gives a force larger by more than {SEEN:.0%} ({scenes} scenes computed).")
    if open_ends:
        text += f" In {open_ends} of these scenes, preloads above 100 πwR may give a larger force."
    return text + " Steep waves on soft spheres were not computed at any preload, because each takes minutes."
