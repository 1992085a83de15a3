"""The functions of libpulloff, as pulloff.h declares them."""

import ctypes
import os
import pathlib

NAME = "libpulloff.so.0"


class Message(ctypes.Structure):
    _fields_ = [("text", ctypes.c_char * 1024)]


class PhysicalScene(ctypes.Structure):
    _fields_ = [(name, ctypes.c_double) for name in
                ("modulus", "work", "distance", "radius", "amplitude", "wavelength", "outer_radius")]


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
    "status_text": (TEXT, STATUS),
    "scene_create": (STATUS, TO(SCENE), MESSAGE),
    "scene_copy": (STATUS, SCENE, TO(SCENE), MESSAGE),
    "scene_destroy": (None, SCENE),
    "key_count": (SIZE,),
    "key_name": (TEXT, SIZE),
    "key_expected": (TEXT, SIZE),
    "scene_set": (STATUS, SCENE, TEXT, TEXT, MESSAGE),
    "scene_set_number": (STATUS, SCENE, TEXT, NUMBER, MESSAGE),
    "scene_get": (STATUS, SCENE, TEXT, ctypes.c_char_p, SIZE, MESSAGE),
    "scene_set_physical": (STATUS, SCENE, TO(PhysicalScene), TO(UnitsOfScene), MESSAGE),
    "scene_set_stop": (None, SCENE, TO(ctypes.c_int)),
    "solve": (STATUS, SCENE, TO(RESULT), MESSAGE),
    "follow": (STATUS, SCENE, TEXT, TO(NUMBER), SIZE, TO(RESULT), MESSAGE),
    "theory": (STATUS, TEXT, SCENE, NUMBER, NUMBER, TO(RESULT), MESSAGE),
    "result_destroy": (None, RESULT),
    "result_status": (STATUS, RESULT),
    "result_reason": (TEXT, RESULT),
    "result_folds": (TO(SpecialPoint), RESULT, TO(SIZE)),
    "result_extrema": (TO(SpecialPoint), RESULT, TO(SIZE)),
    "result_curve": (TO(CurvePoint), RESULT, TO(SIZE)),
    "result_profile": (TO(ProfilePoint), RESULT, TO(SIZE)),
    "result_json": (STATUS, RESULT, TO(ctypes.c_void_p), MESSAGE),
    "free": (None, ctypes.c_void_p),
}


def candidates():
    """The files that may be the library, in order: that of PULLOFF_LIBRARY; below the prefix in which this module is
    installed; what the dynamic linker finds."""
    chosen = os.environ.get("PULLOFF_LIBRARY")
    if chosen:
        return [chosen]
    above = pathlib.Path(__file__).resolve().parents
    # lib, lib/TRIPLE or, where meson does not find dpkg-architecture, lib64 beside lib
    found = [path for folder in above for pattern in ("lib*/" + NAME, "lib*/*/" + NAME) if folder.name.startswith("lib")
             for path in sorted(folder.parent.glob(pattern))]
    return [str(path) for path in found] + [NAME]


def load():
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
