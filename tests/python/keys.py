#!/usr/bin/python3
"""Prints python/pulloff/_keys.py: the keys of the library, for type checkers and editors, which do not run the module.

Usage: keys.py [--write]. The library is that of PULLOFF_LIBRARY, otherwise that of the folder build/."""

import os
import pathlib
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[2]
FOLDER = SOURCE / "python" / "pulloff"
OTHERS = {"profile_file": "Path", "want": "Names", "waves": "Waves", **dict.fromkeys(("young_pa", "poisson", "radius_m"), "Pair"),
          "surface_energies_j_per_m2": "Energies"}
HEAD = '''"""The keys of a scene, for type checkers and editors. This file is made of the keys of the library: after a change of
them, python3 tests/python/keys.py --write makes it anew."""

from typing import TypedDict

from ._values import Energies, Name, Names, Number, Pair, Path, Waves


class Keys(TypedDict, total=False):
'''


def text():
    """The file, for the library that is found."""
    import pulloff
    lines = []
    for key, expected in pulloff.keys().items():
        words = expected.replace(",", "").split()
        kind = OTHERS.get(key, "Number" if "number" in words else "Name")
        lines.append(f"    {key}: {kind}\n")
    return HEAD + "".join(lines)


if __name__ == "__main__":
    os.environ.setdefault("PULLOFF_LIBRARY", str(SOURCE / "build" / "src" / "library" / "libpulloff.so.0"))
    sys.path.insert(0, str(FOLDER.parent))
    if "--write" in sys.argv:
        (FOLDER / "_keys.py").write_text(text(), encoding="utf-8")
    else:
        sys.stdout.write(text())
