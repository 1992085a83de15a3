"""Scenes."""

from __future__ import annotations

import copy
import copyreg
import ctypes
import inspect
import math
import re
import sys
import textwrap
from collections.abc import Iterator, Mapping, MutableMapping
from typing import TYPE_CHECKING, Any

from ._keys import Keys
from ._library import C, Message, UnitsOfScene
from ._result import Result, Units, check, units_of
from ._run import in_library, interruptible, solve_given
from ._values import KEYS, Number, known_key, refuse, text_of

if sys.version_info >= (3, 11):
    from typing import Unpack
elif TYPE_CHECKING:
    from typing_extensions import Unpack


class Scene(MutableMapping[str, Any]):
    """What is solved. Keys are set by arguments or as items; a key that is not set has its default.

        scene = Scene(tabor=3, amplitude=1, wavelength=20)
        scene["outer_radius"] = 100
        del scene["amplitude"]
        scene["tabor"]                     # the text of the value: as it was set, otherwise as the program prints it
        "radius" in scene, list(scene)     # whether a key is set; the keys that are set

    Values are numbers or texts; math.inf is "inf"; None unsets a key. `want` may be a list of names, `waves` one of pairs
    of amplitude and wavelength, `profile_file` any path.

    A scene is a mapping from the keys that are set to their texts: these are copied and pickled, and two scenes are equal
    if they have the same. Scene(mapping, key=value, ...) takes keys from another scene or a dictionary, too.
    """

    __slots__ = ("_given", "__weakref__")
    _given: dict[str, str]

    def __new__(cls, *mapping: Any, **values: Any) -> Scene:
        scene = super().__new__(cls)
        scene._given = {}
        return scene

    def __init__(self, mapping: Mapping[str, Any] | None = None, /, **values: Unpack[Keys]) -> None:
        self.update(mapping, **values)

    def __reduce__(self) -> tuple[Any, ...]:
        state = getattr(self, "__dict__", None), {"_given": dict(self._given)}
        return copyreg.__newobj__, (type(self),), state  # type: ignore[attr-defined]

    def __repr__(self) -> str:
        texts = [f"{key}={_literal(text)}" for key, text in self._given.copy().items()]
        return f"pulloff.Scene({', '.join(texts)})"

    def update(self, mapping: Mapping[str, Any] | None = None, /, **values: Unpack[Keys]) -> None:  # type: ignore[override]
        """Sets several keys, or none of them if one is refused."""
        if mapping is not None and not isinstance(mapping, Mapping):
            raise refuse("the argument of a scene", mapping, "keyword arguments, a scene or a dictionary")
        texts = {known_key(key): text_of(key, value) for key, value in [*(mapping or {}).items(), *values.items()]}
        given = {key: text for key, text in texts.items() if text is not None}
        with in_library(given):  # which refuses a text that it does not accept
            self._given.update(given)  # at once, for other threads
        for key in texts.keys() - given.keys():
            self._given.pop(key, None)

    def __setitem__(self, key: str, value: Any) -> None:
        self.update({key: value})

    def __delitem__(self, key: str) -> None:
        self.update({key: None})

    def __getitem__(self, key: str) -> str:
        given = self._given
        if known_key(key) in given:
            return given[key]
        message, text = Message(), ctypes.create_string_buffer(1024)
        with in_library(given) as handle:
            check(C.pulloff_scene_get(handle, key.encode(), text, len(text), message), message)
        return text.value.decode(errors="replace")

    def __contains__(self, key: object) -> bool:
        return isinstance(key, str) and key in self._given

    def __iter__(self) -> Iterator[str]:
        return iter(list(self._given))

    def __len__(self) -> int:
        return len(self._given)

    def _ipython_key_completions_(self) -> list[str]:
        return list(KEYS)

    @property
    def units(self) -> Units | None:
        """The Units of a scene in SI units; None of others."""
        units, message = UnitsOfScene(), Message()
        with in_library(self._given) as handle:
            status = C.pulloff_scene_units(handle, units, message)
        if status and message.text.startswith(b"the scene is not in SI units"):
            return None
        check(status, message)
        return units_of(units)

    def copy(self) -> Scene:
        """A scene with the same keys."""
        return copy.copy(self)

    @classmethod
    def physical(cls, *, modulus: Number, work: Number, distance: Number, **values: Unpack[Keys]) -> Scene:
        """A scene of SI units, and in `units` of the scene the units of its results.

        modulus: E* = E/(1 - nu^2) of both bodies together, Pa; math.inf is a rigid sphere.
        work: work of adhesion w, J/m^2.  distance: equilibrium distance epsilon of the law, m.
        radius, amplitude, wavelength, outer_radius: m. The radius may be left out beside another profile than a sphere;
        the wavelength has no effect if the amplitude is 0.  Other keys are those in SI units, such as preload_m: a scene
        with `preload`, which is in epsilon, is refused.
        """
        scene = cls(modulus_pa=modulus, work_j_per_m2=work, distance_m=distance)
        lengths = {name + "_m": values.pop(name, None)  # type: ignore[misc]
                   for name in ("radius", "amplitude", "outer_radius", "wavelength")}
        wavelength = lengths.pop("wavelength_m")
        scene.update(lengths, **values)
        if float(scene._given.get("amplitude_m", 1)) == 0:
            del scene["amplitude_m"]
        else:
            scene["wavelength_m"] = wavelength
        if scene._given.get("outer_radius_m") == "inf":
            del scene["outer_radius_m"]
        scene.units  # refuses values that do not agree
        return scene

    def solve(self, **values: Unpack[Keys]) -> Result:
        """Solves the scene, with further keys, which stay unset in the scene itself. Returns a Result. Raises SolveError
        if the solve ended early. Ctrl-C in the main thread ends the solve."""
        scene = self.copy()
        scene.update(**values)
        given = scene._given
        return interruptible(lambda stop: solve_given(given, stop))

    def compare(self, **values: Unpack[Keys]) -> dict[str, dict[str, Any]]:
        """Solves the scene, with further keys, and compares its pull-off force with every theory. Returns {name: row} in
        the order of `pulloff compare`; a row is a dictionary as in the JSON document: force (pi w R; None: not evaluated,
        for the `reason`), deviation (relative), deviation_error_estimate, assumptions ("yes", "no", "unknown"),
        decided_by, number, side, limit, source. Theories that hold for the parabola, but not for a sphere of this radius,
        because the contact is wide, have the key parabola: contact_radius_over_radius, its limit, and exact_sphere, R of the
        profile that is the sphere."""
        want = values.get("want")
        if want is not None:
            raise refuse("want", want, "it to be left out of a comparison")
        for key, text in texts_of(self, values).items():
            if "+-" in text and key != "profile_file":
                raise refuse(key, text, "a number without uncertainty, which only solve takes")
        values["want"] = "theories"
        document = self.solve(**values).document
        rows = {row.pop("theory"): row for row in document["theories"]}
        wide = document.get("parabola", {"theories": []})
        for held in wide.pop("theories"):
            rows[held["theory"]]["parabola"] = dict(wide)
        return rows


def _literal(text: str) -> str:
    try:
        return text if math.isfinite(float(text)) else repr(text)
    except ValueError:
        return repr(text)


def texts_of(scene: Scene | None, values: Mapping[str, Any]) -> dict[str, str]:
    """The texts of a scene, if one is given, with further keys."""
    if not isinstance(scene, (Scene, type(None))):
        raise refuse("scene", scene, "a pulloff.Scene")
    other = Scene(scene)
    other.update(**values)
    return other._given


def name_keys(function: Any) -> None:
    """Gives a function the signature that names the keys of the library, for help() and completion."""
    own = inspect.signature(function).parameters
    named = [p for p in own.values() if p.kind is not p.VAR_KEYWORD]
    named += [inspect.Parameter(key, inspect.Parameter.KEYWORD_ONLY, default=None) for key in KEYS if key not in own]
    function.__signature__ = inspect.Signature(named)


def _describe_keys() -> str:
    """What each key sets, from the help of the options."""
    lines = ["", "    The keys, and the values that they accept:", ""]
    for number, (key, expected) in enumerate(KEYS.items()):
        text = C.pulloff_key_help(number).decode()
        text = re.sub(r"--([a-z-]+)", lambda option: option[1].replace("-", "_"), text)
        lines += textwrap.wrap(f"{key}: {text}; accepts {expected}", 118, initial_indent="    ", subsequent_indent="        ")
    return "\n".join([*lines, "    "])


for _function in (Scene.__new__, Scene.__init__, Scene.update, Scene.solve, Scene.compare,
                  Scene.physical.__func__):  # type: ignore[attr-defined]
    name_keys(_function)
if Scene.__doc__:  # not with python3 -OO
    Scene.__doc__ += _describe_keys()
