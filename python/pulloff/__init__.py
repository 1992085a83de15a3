"""Adhesion of an axisymmetric body and an elastic half-space.

    >>> import pulloff
    >>> result = pulloff.solve(tabor=3, amplitude=1, wavelength=20)
    >>> result.pull_off.force            # in pi w R
    2.65119276...

A scene is described by the keys that the command `pulloff solve` has as options, with _ for -; `pulloff.keys()` lists
them. Lengths are in units of epsilon, the equilibrium distance of the traction-separation law; loads and forces in
pi w R, with the work of adhesion w and the radius R; energies in pi w R epsilon. The approach is positive when the bodies
are pressed together, the load when it is compressive. A scene may be given in SI units, by modulus_pa, work_j_per_m2,
distance_m and radius_m, beside others such as preload_load_n; `units` of a scene and of a result then has the units.

The numbers are those of the program `pulloff` to the last bit. Several threads may solve at the same time.
"""

import contextlib
import ctypes
import dataclasses
import json
import math
import threading

import numpy as np

from ._library import C, CurvePoint, Message, PhysicalScene, ProfilePoint, SpecialPoint, UnitsOfScene

__all__ = ["Error", "PullOff", "Result", "Scene", "SolveError", "Units", "follow", "keys", "solve", "theory", "version"]

_KINDS = np.array(["jump_in", "jump_out", "minimum", "maximum"])


class Error(Exception):
    """A wrong value or scene, a file that cannot be read, or lack of memory. The text states the value and what is
    expected; `status` is the number of pulloff.h."""

    def __init__(self, text, status):
        super().__init__(text)
        self.status = status


class SolveError(Error):
    """A solve that ended early. `result` contains what was found before."""

    def __init__(self, text, status, result):
        super().__init__(text, status)
        self.result = result


def _check(status, message):
    if status < 0:
        raise Error(message.text.decode(), status)
    return status


def version():
    """The version of the loaded library, for example "0.1.0"."""
    return C.pulloff_version().decode()


__version__ = version()


def keys():
    """The keys of a scene: {name: the values that it accepts, in words}."""
    return {C.pulloff_key_name(k).decode(): C.pulloff_key_expected(k).decode() for k in range(C.pulloff_key_count())}


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


def _units(units):
    return Units(units.length, units.force, units.work, units.traction)


class Scene:
    """What is solved. Keys are set by arguments or as items; a key that is not set has its default.

        scene = Scene(tabor=3, amplitude=1, wavelength=20)
        scene["outer_radius"] = 100
        del scene["amplitude"]
        scene["tabor"]                     # the value, defaults included, as the program prints it

    Values are numbers or texts; math.inf is "inf"; None unsets a key. `want` may be a list of names: curve, profile,
    hysteresis, preload, diagnostics, theories.
    """

    def __init__(self, **values):
        self._handle = ctypes.c_void_p()
        message = Message()
        _check(C.pulloff_scene_create(self._handle, message), message)
        self.update(**values)

    def __del__(self):
        if getattr(self, "_handle", None):
            C.pulloff_scene_destroy(self._handle)
            self._handle = None

    def __repr__(self):
        return "<pulloff.Scene " + " ".join(f"{key}={self[key]}" for key in ("tabor", "waves", "profile", "law")) + ">"

    def update(self, **values):
        """Sets several keys."""
        for key, value in values.items():
            self[key] = value

    def __setitem__(self, key, value):
        message = Message()
        if isinstance(value, (list, tuple)):
            value = ",".join(map(str, value))
        if value is None or isinstance(value, str):
            text = None if value is None else value.encode()
            status = C.pulloff_scene_set(self._handle, key.encode(), text, message)
        elif isinstance(value, (int, np.integer)) and not isinstance(value, bool):
            status = C.pulloff_scene_set(self._handle, key.encode(), str(int(value)).encode(), message)
        else:
            status = C.pulloff_scene_set_number(self._handle, key.encode(), float(value), message)
        _check(status, message)

    def __delitem__(self, key):
        self[key] = None

    def __getitem__(self, key):
        message, text = Message(), ctypes.create_string_buffer(1024)
        _check(C.pulloff_scene_get(self._handle, key.encode(), text, len(text), message), message)
        return text.value.decode()

    @property
    def units(self):
        """The Units of a scene in SI units; None of others."""
        units = UnitsOfScene()
        return _units(units) if not C.pulloff_scene_units(self._handle, units, Message()) else None

    def copy(self):
        """A scene with the same keys."""
        other = Scene()
        message, handle = Message(), ctypes.c_void_p()
        _check(C.pulloff_scene_copy(self._handle, handle, message), message)
        C.pulloff_scene_destroy(other._handle)
        other._handle = handle
        return other

    @classmethod
    def physical(cls, *, modulus, work, distance, radius, amplitude=0.0, wavelength=0.0, outer_radius=math.inf, **values):
        """A scene of SI units, and in `units` of the scene the units of its results.

        modulus: E* = E/(1 - nu^2) of both bodies together, Pa; math.inf is a rigid sphere.
        work: work of adhesion w, J/m^2.  distance: equilibrium distance epsilon of the law, m.
        radius, amplitude, wavelength, outer_radius: m.  Other keys are dimensionless, unless their name ends in a unit.
        """
        scene, message = cls(), Message()
        given = PhysicalScene(modulus, work, distance, radius, amplitude, wavelength, outer_radius)
        _check(C.pulloff_scene_set_physical(scene._handle, given, None, message), message)
        scene.update(**values)
        return scene

    def solve(self, **values):
        """Solves the scene, with further keys, which stay unset in the scene itself. Returns a Result. Raises SolveError
        if the solve ended early. Ctrl-C in the main thread ends the solve."""
        scene = self.copy()  # which alone has the flag of an interruption
        scene.update(**values)
        message, handle = Message(), ctypes.c_void_p()
        status = _check(_interruptible(scene, lambda: C.pulloff_solve(scene._handle, handle, message)), message)
        result = Result(handle)
        if status:
            raise SolveError(message.text.decode(), status, result)
        return result


    def compare(self, **values):
        """Solves the scene, with further keys, and compares its pull-off force with every theory. Returns {name: row} in
        the order of `pulloff compare`; a row is a dictionary as in the JSON document: force (pi w R; None: not evaluated,
        for the `reason`), deviation (relative), deviation_error_estimate, assumptions ("yes", "no", "unknown"),
        decided_by, number, side, limit, source."""
        rows = self.solve(**{**values, "want": "theories"}).document["theories"]
        return {row.pop("theory"): row for row in rows}


def _interruptible(scene, call):
    """Runs a call of the library. In the main thread, the call runs in another one, so that a KeyboardInterrupt can set
    the flag that ends it."""
    if threading.current_thread() is not threading.main_thread():
        return call()
    stop, found = ctypes.c_int(0), []
    C.pulloff_scene_set_stop(scene._handle, stop)
    worker = threading.Thread(target=lambda: found.append(call()))
    worker.start()
    try:
        worker.join()
    except BaseException:
        stop.value = 1
        with contextlib.suppress(KeyboardInterrupt):
            worker.join()
        raise
    finally:
        C.pulloff_scene_set_stop(scene._handle, None)
    return found[0]


def _array(function, handle, structure):
    """A copy of an array of the library as a structured array."""
    count = ctypes.c_size_t()
    first = function(handle, count)
    content = ctypes.string_at(first, count.value * ctypes.sizeof(structure)) if count.value else b""
    return np.frombuffer(content, np.dtype(structure)).copy()


def _special_points(function, handle):
    points = _array(function, handle, SpecialPoint)
    named = np.empty(len(points), [("kind", "U8")] + [(name, points.dtype[name]) for name in points.dtype.names[1:]])
    named["kind"] = _KINDS[points["kind"]]
    for name in points.dtype.names[1:]:
        named[name] = points[name]
    return named


class Result:
    """The result of a solve. All arrays are copies that belong to the caller.

    status: "ok", or why the solve ended early;  reason: where, in words.
    pull_off: a PullOff, or None.
    folds, extrema: structured arrays of the special points in order along the branch, with the fields kind (jump_in,
        jump_out, minimum, maximum), approach, approach_error, contact_radius (epsilon), load, load_error (pi w R),
        energy, energy_error (pi w R epsilon), position (arclength), unstable_modes (after the point, at given approach).
    curve: structured array of the points of the branch, with the fields position, approach, load, energy,
        energy_error (of the energy at this approach), contact_radius, approach_rate, load_rate (derivatives with respect to the position), unstable_modes (0: stable
        at given approach); empty unless wanted.
    profile: structured array with the fields radius (epsilon), gap (H = h/epsilon - 1), traction (P = p mu epsilon/w,
        > 0 compressive); empty unless wanted.
    document: the JSON document of `pulloff solve --json` as dictionaries and lists. Its numbers are those above to the
        last bit; result["hysteresis"] is result.document["hysteresis"].
    units: the Units of its scene, if that is in SI units; in a series each result has its own.
    """

    def __init__(self, handle):
        units = UnitsOfScene()
        try:
            self.document = _document(handle)
            self.units = _units(units) if C.pulloff_result_units(handle, units) else None
            self.folds = _special_points(C.pulloff_result_folds, handle)
            self.extrema = _special_points(C.pulloff_result_extrema, handle)
            self.curve = _array(C.pulloff_result_curve, handle, CurvePoint)
            self.profile = _array(C.pulloff_result_profile, handle, ProfilePoint)
        finally:
            C.pulloff_result_destroy(handle)
        self.status = self.document["status"]
        self.reason = self.document["reason"]
        found = self.document["pull_off"]
        self.pull_off = found and PullOff(*(
            math.nan if found[name] is None else found[name] for name in
            ("force", "error_estimate", "approach", "approach_error_estimate", "contact_radius",
             "contact_radius_error_estimate")))

    def __getitem__(self, name):
        return self.document[name]

    def __repr__(self):
        force = f", pull-off force {self.pull_off.force:.7g}" if self.pull_off else ""
        return f"<pulloff.Result {self.status}{force}>"


def _document(handle):
    message, text = Message(), ctypes.c_void_p()
    _check(C.pulloff_result_json(handle, text, message), message)
    try:
        return json.loads(ctypes.string_at(text))
    finally:
        C.pulloff_free(text)


def solve(**values):
    """Solves the scene with these keys: Scene(**values).solve()."""
    return Scene(**values).solve()


def follow(key, values, scene=None, **others):
    """Solves scenes that differ in one key, which may be in SI units, by parameter continuation, which takes a fraction of the time of single
    solves. values: ascending or descending. scene: a Scene; others: further keys. Returns a list of Results, whose
    arrays of points are empty where the pull-off was followed. A solve that fails does not raise: see `status` of each.
    """
    scene = scene.copy() if scene else Scene()
    scene.update(**others)
    numbers = np.ascontiguousarray(values, dtype=float)
    handles, message = (ctypes.c_void_p * len(numbers))(), Message()
    first = numbers.ctypes.data_as(ctypes.POINTER(ctypes.c_double))
    _check(_interruptible(scene, lambda: C.pulloff_follow(scene._handle, key.encode(), first, len(numbers), handles,
                                                          message)), message)
    return [Result(ctypes.c_void_p(handle)) for handle in handles]


def theory(form, *, at=math.nan, alpha=math.nan, scene=None, **values):
    """Evaluates a closed form (bradley, jkr, guduru, kesari-lew, ...; `pulloff theory --help` lists them) for the scene
    with these keys. at: the approach, contact radius (epsilon) or gap at which a form that is a curve is evaluated.
    alpha: A R/lambda^2 in place of the wavelength. A key on which the form does not depend is refused. Returns
    {name: number}, in the units of a scene; None is infinite.
    """
    scene = scene.copy() if scene else Scene()
    scene.update(**values)
    handle, message = ctypes.c_void_p(), Message()
    _check(C.pulloff_theory(form.encode(), scene._handle, alpha, at, handle, message), message)
    try:
        found = _document(handle)
    finally:
        C.pulloff_result_destroy(handle)
    return {name: value for name, value in found.items() if name not in ("schema", "theory")}
