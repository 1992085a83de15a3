"""What a user gives as the value of a key, as the text that the library reads. A value that is of no use is refused here,
with the key, the value and what was expected: none is converted to another one silently."""

from __future__ import annotations

import decimal
import difflib
import fractions
import math
import numbers
import os
import reprlib
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Optional, Union

import numpy as np

from ._library import C

#: A real number, or its text in decimal notation; None unsets a key.
Number = Union[float, decimal.Decimal, fractions.Fraction, np.floating, np.integer, str, None]
Name = Optional[str]
Names = Union[str, list[str], tuple[str, ...], set[str], frozenset[str], None]
Path = Union[str, bytes, os.PathLike[str], os.PathLike[bytes], None]
Waves = Union[str, Sequence[Sequence[Number]], np.ndarray, None]
Pair = Union[Number, Sequence[Number]]  # of two bodies, or of one
Energies = Union[str, Sequence[Number], None]  # of two surfaces, and of the interface

BAD_INPUT = -1


class Error(Exception):
    """A wrong value or scene, a file that cannot be read, or lack of memory. The text states the value and what is
    expected; `status` is the number of pulloff.h."""

    status: int

    def __init__(self, text: str, status: int = BAD_INPUT) -> None:
        super().__init__(text)  # with which, and the attributes, an exception is pickled
        self.status = status


def keys() -> dict[str, str]:
    """The keys of a scene: {name: the values that it accepts, in words}."""
    return {C.pulloff_key_name(k).decode(): C.pulloff_key_expected(k).decode() for k in range(C.pulloff_key_count())}


KEYS = keys()

_LISTS = {"waves": ", or [(A, L), ...]", "want": ", or a list of them"} | {
    "surface_energies_j_per_m2": ", or a tuple of them"} | dict.fromkeys(("young_pa", "poisson", "radius_m"), ", or a pair")


def shown(value: object) -> str:
    """A value in a message: one short line."""
    try:
        return " ".join(_short.repr(value).split())
    except Exception:  # also of a number of too many digits
        return f"an object of the type {type(value).__name__}"


_short = reprlib.Repr()
_short.maxstring = _short.maxother = 80


def refuse(name: str, value: object, expected: str) -> Error:
    return Error(f"{name} is {shown(value)}: expected {expected}")


def known_key(key: object) -> str:
    """A key of a scene. Raises Error for others."""
    if not isinstance(key, str):
        raise refuse("the key of a scene", key, "a text, one of pulloff.keys()")
    if key not in KEYS:
        near = difflib.get_close_matches(key, KEYS, 1)
        raise Error(f"unknown key {key if key.isprintable() else shown(key)} of a scene: expected one of pulloff.keys()"
                    + (f"; did you mean {near[0]}?" if near else ""))
    return str.__str__(key)


def number(value: object) -> str | None:
    """The text of a real number, which is read to the same bits, or None. A number that is so large or so small that it
    would become infinite or 0 is none."""
    if isinstance(value, np.ndarray) and value.ndim == 0 and not isinstance(value, np.ma.MaskedArray):
        value = value[()]
    if isinstance(value, (bool, np.timedelta64)) or not isinstance(value, (numbers.Real, decimal.Decimal)):
        return None
    try:
        if isinstance(value, numbers.Integral):
            return str(int(value))
        nearest = float(value)
        if (math.isinf(nearest) or nearest == 0) and nearest != value:
            return None
    except Exception:  # of whatever class the number has
        return None
    text = repr(nearest)
    return text[:-2] if text.endswith(".0") else text


def float_of(name: str, value: object, expected: str) -> float:
    """A number that is neither text nor nan. Raises Error, also for an integer beyond the largest double."""
    text = number(value)
    if text is None or text == "nan" or (math.isinf(float(text)) and not text.endswith("inf")):
        raise refuse(name, value, expected)
    return float(text)


def series_of(key: str, values: object) -> list[float]:
    """The values of a series. Raises Error."""
    expected = "a one-dimensional sequence of real numbers"
    if isinstance(values, np.ma.MaskedArray):
        raise Error(f"values is a masked array: expected {expected}; values.compressed() has those that are not masked")
    if isinstance(values, np.ndarray) and values.ndim != 1:
        raise Error(f"values is an array of shape {values.shape}: expected {expected}")
    if isinstance(values, (str, bytes, bytearray, memoryview, Mapping)) or not isinstance(values, Iterable):
        raise refuse("values", values, expected)
    return [float_of(f"values[{k}] of {key}", value, KEYS.get(key, "a real number")) for k, value in enumerate(values)]


def encoded(name: str, text: object, expected: str) -> bytes:
    """A text as the library takes it. The name of a file may have bytes that are no UTF-8 (os.fsdecode). Raises Error."""
    try:
        if isinstance(text, str) and "\0" not in text:
            return text.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        pass
    raise refuse(name, text, expected)


def _path(value: object) -> str | None:
    try:
        return os.fsdecode(value)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        return None


def _names(value: object) -> str | None:
    if isinstance(value, (list, tuple, set, frozenset)) and all(isinstance(name, str) for name in value):
        return ",".join(value)
    return None


def _waves(value: object) -> str | None:
    if isinstance(value, np.ndarray) and not isinstance(value, np.ma.MaskedArray) and value.ndim == 2:
        value = list(value)
    if not isinstance(value, (list, tuple)):
        return None
    waves = []
    for wave in value:
        if isinstance(wave, np.ndarray):
            wave = None if wave.ndim != 1 or isinstance(wave, np.ma.MaskedArray) else list(wave)
        if not isinstance(wave, (list, tuple)):
            return None
        pair = [part if isinstance(part, str) and "@" not in part else number(part) for part in wave]
        if len(pair) != 2 or None in pair:
            return None
        waves.append(f"{pair[0]}@{pair[1]}")
    return ";".join(waves) or "-"


def _list(value: object) -> str | None:
    if not isinstance(value, (list, tuple)) or len(value) not in (2, 3):
        return number(value)
    parts = [part if isinstance(part, str) else number(part) for part in value]
    return None if None in parts else ",".join(map(str, parts))


def _pair(value: object) -> str | None:
    return None if isinstance(value, (list, tuple)) and len(value) != 2 else _list(value)


_OTHERS: dict[str, Callable[[object], str | None]] = {"profile_file": _path, "want": _names, "waves": _waves,
                                                      "young_pa": _pair, "poisson": _pair, "radius_m": _pair, "surface_energies_j_per_m2": _list}


def text_of(key: str, value: object) -> str | None:
    """The text of the value of a key; None unsets the key. Raises Error for a value of a wrong type."""
    if value is None:
        return None
    text = str.__str__(value) if isinstance(value, str) else _OTHERS.get(key, number)(value)
    expected = KEYS[key] + _LISTS.get(key, "")
    if text is None:
        raise refuse(key, value, expected)
    encoded(key, text, expected)
    return text
