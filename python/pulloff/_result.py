"""Results, as copies of those of the library."""

from __future__ import annotations

import ctypes
import dataclasses
import json
import math
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from ._library import C, CurvePoint, Message, ProfilePoint, SpecialPoint, UnitsOfScene
from ._values import Error

_LOOP = [("phase", "U9"), ("jump", bool), *((name, float) for name in (
    "base", "approach", "indentation", "load", "contact_radius", "stiffness", "energy_lost"))]

_KINDS = np.array(["jump_in", "jump_out", "minimum", "maximum"])


def check(status: int, message: Message) -> int:
    if status < 0:
        raise Error(message.text.decode(errors="replace"), status)
    return status


@dataclasses.dataclass(frozen=True)
class PullOff:
    """The pull-off, with estimated bounds of the errors (nan: not estimated by the scheme)."""

    force: float  #: magnitude, pi w R
    force_error: float
    approach: float  #: epsilon
    approach_error: float
    contact_radius: float  #: epsilon
    contact_radius_error: float


@dataclasses.dataclass(frozen=True)
class Units:
    """The SI values of the units of dimensionless numbers: a number times its unit is its SI value."""

    length: float  #: epsilon, m: unit of approach and radii
    force: float  #: pi w R, N: unit of load and force
    work: float  #: w, J/m^2
    traction: float  #: w/(mu epsilon), Pa: unit of tractions; inf if rigid


def units_of(units: UnitsOfScene) -> Units:
    return Units(units.length, units.force, units.work, units.traction)


def _array(function: Any, handle: ctypes.c_void_p, structure: Any) -> np.ndarray:
    """A copy of an array of the library as a structured array."""
    count = ctypes.c_size_t()
    first = function(handle, count)
    content = ctypes.string_at(first, count.value * ctypes.sizeof(structure)) if count.value else b""
    return np.frombuffer(content, np.dtype(structure)).copy()


def _special_points(function: Any, handle: ctypes.c_void_p) -> np.ndarray:
    points = _array(function, handle, SpecialPoint)
    names = [name for name in points.dtype.names or () if name != "kind"]
    named = np.empty(len(points), [("kind", "U8"), *((name, points.dtype[name]) for name in names)])
    named["kind"] = _KINDS[points["kind"]]
    for name in names:
        named[name] = points[name]
    return named


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Result(Mapping[str, Any]):
    """The result of a solve. All arrays are copies that belong to the caller.

    status: "ok", or why the solve ended early;  reason: where, in words.
    pull_off: a PullOff, or None.
    folds, extrema: structured arrays of the special points in order along the branch, with the fields kind (jump_in,
        jump_out, minimum, maximum), approach, approach_error, contact_radius (epsilon), load, load_error (pi w R),
        energy, energy_error (pi w R epsilon), position (arclength), unstable_modes (after the point, at given approach).
    curve: structured array of the points of the branch, with the fields position, approach, load, energy, energy_error
        (of the energy at this approach), contact_radius, approach_rate, load_rate (derivatives with respect to the
        position), unstable_modes (0: stable at given approach); empty unless wanted.
    profile: structured array with the fields radius (epsilon), gap (H = h/epsilon - 1), traction (P = p mu epsilon/w,
        > 0 compressive); empty unless wanted.
    loop: structured array of what a test records, through the spring or without one at given approach, with the fields
        phase (loading, unloading), jump (whether a jump ends at the row), base, approach, indentation, contact_radius
        (epsilon), load (pi w R), stiffness (pi w R/epsilon, nan at a fold), energy_lost (pi w R epsilon, in that jump);
        empty unless wanted.
    digest: 16 digits that stand for all results; equal digests are equal results, to the last bit.
    document: the JSON document of `pulloff solve --json` as dictionaries and lists. Its numbers are those above to the
        last bit. A result is a mapping of it: result["hysteresis"] is result.document["hysteresis"].
    units: the Units of its scene, if that is in SI units; in a series each result has its own.
    """

    document: dict[str, Any]
    pull_off: PullOff | None
    folds: np.ndarray
    extrema: np.ndarray
    curve: np.ndarray
    profile: np.ndarray
    units: Units | None

    @property
    def status(self) -> str:
        return self.document["status"]  # type: ignore[no-any-return]

    @property
    def reason(self) -> str:
        return self.document["reason"]  # type: ignore[no-any-return]

    @property
    def digest(self) -> str:
        return self.document["digest"]  # type: ignore[no-any-return]

    @property
    def loop(self) -> np.ndarray:
        found = self.document.get("hysteresis", {})
        rows = found.get("spring", found.get("displacement_control", {})).get("path", {}).get("rows", [])
        return np.array([tuple(math.nan if row[name] is None else row[name] for name, _ in _LOOP) for row in rows], _LOOP)

    def __getitem__(self, name: str) -> Any:
        return self.document[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.document)

    def __len__(self) -> int:
        return len(self.document)

    def _ipython_key_completions_(self) -> list[str]:
        return list(self.document)

    def __repr__(self) -> str:
        force = f", pull-off force {self.pull_off.force:.7g}" if self.pull_off else ""
        return f"<pulloff.Result {self.status}{force}>"


def result_of(handle: ctypes.c_void_p) -> Result:
    """A copy of a result of the library."""
    document, units = document_of(handle), UnitsOfScene()
    found = document["pull_off"]
    numbers = [] if found is None else [
        math.nan if found[name] is None else found[name] for name in
        ("force", "error_estimate", "approach", "approach_error_estimate", "contact_radius", "contact_radius_error_estimate")]
    return Result(document, PullOff(*numbers) if numbers else None, _special_points(C.pulloff_result_folds, handle),
                  _special_points(C.pulloff_result_extrema, handle), _array(C.pulloff_result_curve, handle, CurvePoint),
                  _array(C.pulloff_result_profile, handle, ProfilePoint),
                  units_of(units) if C.pulloff_result_units(handle, units) else None)


def document_of(handle: ctypes.c_void_p) -> dict[str, Any]:
    message, text = Message(), ctypes.c_void_p()
    check(C.pulloff_result_json(handle, text, message), message)
    try:
        return json.loads(ctypes.string_at(text))  # type: ignore[no-any-return, arg-type]
    finally:
        C.pulloff_free(text)


class SolveError(Error):
    """A solve that ended early. `result` contains what was found before."""

    result: Result | None

    def __init__(self, text: str, status: int = 1, result: Result | None = None) -> None:
        super().__init__(text, status)
        self.result = result
