"""Tests that the program takes no function whose rounding depends on the machine from a library.

Usage: symbols.py PROGRAM

Of the C library's mathematics only functions may be called that are exact or correctly rounded; of GSL only tables of
Gauss's rules and the error handler; of LAPACK only the estimate of the condition number. Code of the program has no
`long double`.
"""

import pathlib
import re
import subprocess
import sys

EXACT = {"fmax", "fmin", "fmod", "remainder", "frexp", "ldexp", "lround", "round", "nextafter", "rint", "nearbyint", "floor",
         "ceil", "trunc", "sqrt", "sqrtf", "fabs", "copysign", "scalbn", "modf", "lrint", "logb", "ilogb"}
OTHERS = {"LAPACKE_dgecon", "gsl_integration_glfixed_point", "gsl_integration_glfixed_table_alloc",
          "gsl_integration_glfixed_table_free", "gsl_set_error_handler_off", "gsl_version"}
SOURCE = pathlib.Path(__file__).parents[2] / "src"


def symbols(*command):
    printed = subprocess.run(["nm", "-D", *command], capture_output=True, text=True, check=True).stdout
    return {line.split()[-1].split("@")[0] for line in printed.splitlines()}


def library(program, name):
    printed = subprocess.run(["ldd", program], capture_output=True, text=True, check=True).stdout
    return re.search(rf"^\s*{name}\S* => (\S+)", printed, flags=re.M).group(1)


def main():
    program = sys.argv[1]
    used = symbols("--undefined-only", program)
    of_mathematics = used & symbols("--defined-only", library(program, "libm.so"))
    of_others = {name for name in used if re.match(r"gsl_|cblas_|LAPACKE_|\w+_$", name) and not name.startswith(("_", "blas_"))}
    assert "frexp" in of_mathematics and "LAPACKE_dgecon" in of_others, "the symbols of the program are not seen"
    wrong = sorted(of_mathematics - EXACT | of_others - OTHERS)
    for path in sorted(SOURCE.rglob("*.[ch]")):
        code = re.sub(r"/\*.*?\*/|//[^\n]*", "", path.read_text(), flags=re.S)
        wrong += [f"{path.name}: {found}" for found in re.findall(r"long double|\b[0-9.]+(?:e-?\d+)?L\b", code) if "." in found or "long" in found]
    for name in wrong:
        print(f"{name}: its result may depend on the machine; see doc/method.md, The same bits")
    return int(bool(wrong))


if __name__ == "__main__":
    sys.exit(main())
