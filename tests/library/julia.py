"""The calls of doc/examples/pull_off.jl have the signatures of pulloff.h. Where Julia is installed, the example is run, too.

Usage: julia.py ROOT LIBRARY
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

POINTER, TEXT = "Ptr{Cvoid}", "Cstring"
TYPES = {"pulloff_status": "Cint", "void": "Cvoid", "pulloff_scene *": POINTER, "pulloff_result *": POINTER, "char *": TEXT,
         "pulloff_scene **": "Ref{Ptr{Cvoid}}", "pulloff_result **": "Ref{Ptr{Cvoid}}", "pulloff_message *": "Ptr{UInt8}",
         "double *": "Ref{Cdouble}", "size_t": "Csize_t", "size_t *": "Ref{Csize_t}"}
ARRAYS = {"double *values": "Ptr{Cdouble}"}  # in pulloff_result_column


def julia_type(parameter):
    plain = parameter.replace("const ", "").strip()
    return ARRAYS.get(plain) or TYPES[re.sub(r"\w+$", "", plain).strip()]


def main():
    root, library = map(pathlib.Path, sys.argv[1:])
    header = re.sub(r"/\*.*?\*/", "", (root / "src/library/pulloff.h").read_text(), flags=re.S)
    example = root / "doc/examples/pull_off.jl"
    calls = re.findall(r"ccall\(\(:(\w+), LIB\), (\w+), \(([^()]*)\)", example.read_text())
    wrong = [] if len(calls) >= 7 and len(calls) == example.read_text().count("ccall") else ["calls are not seen"]
    for name, returned, types in calls:
        found = re.search(rf"^([\w ]+?) ?\b{name}\(([^)]*)\);", header, flags=re.M)
        if not found:
            wrong.append(f"{name} is not in pulloff.h")
            continue
        expected = [julia_type(text) for text in re.sub(r"\s+", " ", found[2]).split(",")]
        given = [word.strip() for word in types.split(",") if word.strip()]
        if given != expected or returned != TYPES[found[1]]:
            wrong.append(f"{name}: {returned} of {given}, expected {TYPES[found[1]]} of {expected}")
    if not wrong and shutil.which("julia"):
        ran = subprocess.run(["julia", "--startup-file=no", example, "tabor=1"], capture_output=True, text=True, check=False,
                             env={**os.environ, "LD_LIBRARY_PATH": str(library.resolve().parent)})
        if not ran.stdout.startswith("pull-off force 1.67066477"):
            wrong.append(ran.stdout + ran.stderr)
    print("\n".join(wrong) or f"{len(calls)} calls as in pulloff.h")
    return int(bool(wrong))


if __name__ == "__main__":
    sys.exit(main())
