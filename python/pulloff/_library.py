"""The functions of libpulloff, as pulloff.h declares them."""

from __future__ import annotations

import ctypes
import os
import pathlib
import shutil
import subprocess
from collections.abc import Iterator

NAME = "libpulloff-0.dll" if os.name == "nt" else "libpulloff.so.0"


class Message(ctypes.Structure):
    _fields_ = [("text", ctypes.c_char * 1024)]


class UnitsOfScene(ctypes.Structure):
    _fields_ = [(name, ctypes.c_double) for name in ("length", "force", "work", "traction")]


class SpecialPoint(ctypes.Structure):
    _fields_ = [("kind", ctypes.c_int), ("unstable_modes", ctypes.c_int)] + [
        (name, ctypes.c_double) for name in ("approach", "approach_error", "load", "load_error", "contact_radius",
                                             "energy", "energy_error", "position")]


class CurvePoint(ctypes.Structure):
    _fields_ = [(name, ctypes.c_double) for name in ("position", "approach", "load", "energy", "energy_error", "contact_radius",
                                                     "approach_rate", "load_rate")] + [("unstable_modes", ctypes.c_int)]


class ProfilePoint(ctypes.Structure):
    _fields_ = [(name, ctypes.c_double) for name in ("radius", "gap", "traction")]


SCENE = RESULT = ctypes.c_void_p
STATUS, TEXT, NUMBER, SIZE = ctypes.c_int, ctypes.c_char_p, ctypes.c_double, ctypes.c_size_t
MESSAGE = ctypes.POINTER(Message)
TO = ctypes.POINTER

FUNCTIONS = {
    "version": (TEXT,),
    "scene_create": (STATUS, TO(SCENE), MESSAGE),
    "scene_destroy": (None, SCENE),
    "key_count": (SIZE,),
    "key_name": (TEXT, SIZE),
    "key_expected": (TEXT, SIZE),
    "key_help": (TEXT, SIZE),
    "scene_set": (STATUS, SCENE, TEXT, TEXT, MESSAGE),
    "scene_get": (STATUS, SCENE, TEXT, ctypes.c_char_p, SIZE, MESSAGE),
    "scene_units": (STATUS, SCENE, TO(UnitsOfScene), MESSAGE),
    "scene_set_stop": (None, SCENE, TO(ctypes.c_int)),
    "scene_set_seen": (None, SCENE, TO(ctypes.c_int)),
    "solve": (STATUS, SCENE, TO(RESULT), MESSAGE),
    "follow": (STATUS, SCENE, TEXT, TO(NUMBER), SIZE, TO(RESULT), MESSAGE),
    "theory": (STATUS, TEXT, SCENE, NUMBER, NUMBER, TO(RESULT), MESSAGE),
    "theory_at": (STATUS, TEXT, SCENE, NUMBER, TEXT, NUMBER, TO(RESULT), MESSAGE),
    "result_destroy": (None, RESULT),
    "result_folds": (TO(SpecialPoint), RESULT, TO(SIZE)),
    "result_extrema": (TO(SpecialPoint), RESULT, TO(SIZE)),
    "result_curve": (TO(CurvePoint), RESULT, TO(SIZE)),
    "result_profile": (TO(ProfilePoint), RESULT, TO(SIZE)),
    "result_units": (ctypes.c_bool, RESULT, TO(UnitsOfScene)),
    "result_json": (STATUS, RESULT, TO(ctypes.c_void_p), MESSAGE),
    "free": (None, ctypes.c_void_p),
}


def candidates() -> Iterator[str]:
    """The files that may be the library, in order: that of PULLOFF_LIBRARY; that of a wheel, beside this module; below the
    prefix in which this module is installed, and that of the program pulloff in PATH; what the dynamic linker finds; what
    pkg-config names."""
    chosen = os.environ.get("PULLOFF_LIBRARY")
    if chosen:
        yield chosen
        return
    own = pathlib.Path(__file__).with_name(NAME)
    if own.is_file():
        yield str(own)
    prefixes = [folder.parent for folder in pathlib.Path(__file__).resolve().parents if folder.name.startswith("lib")]
    program = shutil.which("pulloff")
    if program:
        prefixes.append(pathlib.Path(program).resolve().parents[1])
    for prefix in prefixes:  # lib, lib/TRIPLE or, where meson does not find dpkg-architecture, lib64 beside lib
        for pattern in ("lib*/" + NAME, "lib*/*/" + NAME):
            yield from map(str, sorted(prefix.glob(pattern)))
    yield NAME
    if shutil.which("pkg-config"):
        said = subprocess.run(["pkg-config", "--variable=libdir", "pulloff"], capture_output=True, text=True)
        if said.stdout.strip():
            yield os.path.join(said.stdout.strip(), NAME)


def load() -> ctypes.CDLL:
    reason: object = None
    for name in candidates():
        try:
            library = ctypes.CDLL(name)
            break
        except OSError as error:
            reason = error
    else:
        raise ImportError(f"the C library of pulloff cannot be loaded ({reason}): install it, or set PULLOFF_LIBRARY "
                          f"to its file, {NAME}")
    for name, (returned, *arguments) in FUNCTIONS.items():
        function = getattr(library, "pulloff_" + name)
        function.restype, function.argtypes = returned, arguments
    return library


C = load()
