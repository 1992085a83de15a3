"""Adhesion of an axisymmetric body and an elastic half-space.

    >>> import pulloff
    >>> result = pulloff.solve(tabor=3, amplitude=1, wavelength=20)
    >>> result.pull_off.force            # in pi w R
    2.65119276...

A scene is described by the keys that the command `pulloff solve` has as options, with _ for -; help(pulloff.Scene) says
what each of them sets, `pulloff.keys()` which values it accepts. Lengths are in units of epsilon, the equilibrium distance
of the traction-separation law; loads and forces in pi w R, with the work of adhesion w and the radius R; energies in
pi w R epsilon. The approach is positive when the bodies are pressed together, the load when it is compressive. A scene may
be given in SI units, by modulus_pa, work_j_per_m2, distance_m and radius_m, beside others such as preload_load_n; `units`
of a scene and of a result then has the units.

The numbers are those of the program `pulloff` to the last bit. Several threads may solve at the same time. Scenes, results
and exceptions can be copied and pickled, for example for processes of multiprocessing.
"""

from __future__ import annotations

import ctypes
import math
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from ._keys import Keys
from ._library import C, Message
from ._result import PullOff, Result, SolveError, Units, check, document_of
from ._run import Progress, follow_given, in_library, interruptible, print_progress, solve_given
from ._scene import Scene, name_keys, texts_of
from ._values import KEYS, Error, Number, encoded, float_of, keys, refuse, series_of

if sys.version_info >= (3, 11):
    from typing import Unpack
elif TYPE_CHECKING:
    from typing_extensions import Unpack

__all__ = ["Error", "PullOff", "Result", "Scene", "SolveError", "Units", "follow", "keys", "solve", "theory", "version"]


def version() -> str:
    """The version of the loaded library, for example "0.1.0"."""
    return C.pulloff_version().decode()


__version__ = version()


def solve(scene: Scene | None = None, **values: Unpack[Keys]) -> Result:
    """Solves the scene with these keys: Scene(**values).solve(), or scene.solve(**values)."""
    given = texts_of(scene, values)
    return interruptible(lambda stop: solve_given(given, stop))


def follow(key: str, values: Any, scene: Scene | None = None, *, progress: bool | Callable[[int, int], object] = False,
           **others: Unpack[Keys]) -> list[Result]:
    """Solves scenes that differ in one key, which may be in SI units, by parameter continuation, which takes a fraction of
    the time of single solves. values: ascending or descending. scene: a Scene; others: further keys. Returns a list of
    Results, whose arrays of points are empty where the pull-off was followed. A solve that fails does not raise: see
    `status` of each.

    progress: True prints a line with the number of scenes on standard error; a function progress(seen, count) is called,
    in this thread, whenever the number of scenes that have been seen has grown, and at the end with seen = count. An
    exception that it raises ends the series. So does Ctrl-C in the main thread.
    """
    if not callable(progress) and progress is not True and progress is not False and progress is not None:
        raise refuse("progress", progress, "True, False or a function of two numbers")
    name = encoded("key", key, "a text")
    if others.get(key) is not None:
        raise refuse(key, others[key], "it to be left out, as its value varies")  # type: ignore[literal-required]
    numbers, given = series_of(key, values), texts_of(scene, others)
    show = Progress(len(numbers), print_progress if progress is True else progress) if progress else None
    results = interruptible(lambda stop: follow_given(given, name, numbers, stop, show), show)
    if show:
        show(last=True)
    return results


def theory(form: str, *, at: Number = None, load: Number = None, approach: Number = None, contact_radius: Number = None,
           load_n: Number = None, approach_m: Number = None, contact_radius_m: Number = None, scene: Scene | None = None,
           **values: Unpack[Keys]) -> dict[str, Any]:
    """Evaluates a closed form (bradley, jkr, guduru, kesari-lew, ...; `pulloff theory --help` lists them) for the scene
    with these keys. at: the approach, contact radius (epsilon) or gap at which a form that is a curve is evaluated.
    load, approach, or these in SI units: the stable state there (jkr, dmt, maugis, guduru), of unloading after the preload
    of the scene (preload, preload_load, which jkr, guduru and persson-brener take), without one from the hardest preload. alpha:
    A R/lambda^2 in place of the wavelength. A key on which the form does not depend is refused. Returns {name: number}, in
    the units of a scene; None is infinite; `assumes` has the equation, the preload and the branch in words. With
    want="curve" `curve` has arrays of approach, load and contact radius, and of whether the state is stable.
    """
    place = {name: math.nan if value is None else float_of(name, value, "a finite number, or None")
             for name, value in (("at", at), ("alpha", values.pop("alpha", None)))}
    states = {name: float_of(name, value, "a finite number, or None") for name, value in (
        ("load", load), ("approach", approach), ("contact_radius", contact_radius), ("load_n", load_n),
        ("approach_m", approach_m), ("contact_radius_m", contact_radius_m)) if value is not None}
    if len(states) + (at is not None) > 1:
        raise Error(f"{', '.join(states)}{' and at' if at is not None else ''} are given: expected one of them")
    name = encoded("form", form, "the name of a closed form")
    handle, message = ctypes.c_void_p(), Message()
    with in_library(texts_of(scene, values)) as handle_of_scene:
        status = C.pulloff_theory(name, handle_of_scene, place["alpha"], place["at"], handle, message) if not states else \
            C.pulloff_theory_at(name, handle_of_scene, place["alpha"], *[(key.encode(), number) for key, number in states.items()][0],
                                handle, message)
        check(status, message)
    try:
        found = document_of(handle)
    finally:
        C.pulloff_result_destroy(handle)
    if "curve" in found:
        found["curve"] = {key: np.array([point[key] for point in found["curve"]]) for key in found["curve"][0]}
    return {name: value for name, value in found.items() if name not in ("schema", "theory")}


for _function in (solve, follow, theory):
    name_keys(_function)
for _name in __all__:  # the names by which objects are pickled, whatever the files of this module are
    globals()[_name].__module__ = __name__
