"""The law of contact for particle codes: its cubics against another solve, its invariance, its files as programs read them,
and two particles that collide head on, integrated by a C program with the generated header, against the energy that the
quasi-static path of the solver loses."""

import csv
import math
import pathlib
import shutil
import signal
import subprocess
import time

import pytest
import conftest
from conftest import document, expect, run

SI = "--from-physical --modulus-pa 1.3385e9 --work-j-per-m2 0.0537 --distance-m 3.1e-10 --radius-m 2.7e-8"
COMPILER = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
needs_compiler = pytest.mark.skipif(not COMPILER, reason="no C compiler")


def law(words):
    """The knots of a law by branch, from its CSV table."""
    text = expect(0, "", f"contact-law {words} --format csv").out
    rows = list(csv.reader(line for line in text.splitlines() if not line.startswith("#")))
    branches = {"out": [], "in": []}
    for row in rows[1:]:
        branches[row[0]].append([float(cell) for cell in row[1:]])
    return branches, rows[0], text


def cubic(knots, x, value=1, slope=2):
    """Value and slope of the cubics between knots."""
    k = next(k for k in range(1, len(knots)) if x <= knots[k][0] or k + 1 == len(knots))
    a, b = knots[k - 1], knots[k]
    h = b[0] - a[0]
    t = (x - a[0]) / h
    rise, p, q = b[value] - a[value], h * a[slope], h * b[slope]
    return (a[value] + t * (p + t * (3 * rise - 2 * p - q + t * (p + q - 2 * rise))),
            (p + t * (2 * (3 * rise - 2 * p - q) + t * 3 * (p + q - 2 * rise))) / h)


def area(knots, low, high):
    """Simpson's rule in each interval, which is exact for cubics."""
    total = 0.0
    for a, b in zip(knots, knots[1:]):
        x, y = max(a[0], low), min(b[0], high)
        if x < y:
            total += (y - x) / 6 * (cubic([a, b], x)[0] + 4 * cubic([a, b], 0.5 * (x + y))[0] + cubic([a, b], y)[0])
    return total


@pytest.mark.once
@pytest.mark.parametrize("scene, error", [("--tabor 2.385", 1e-4), ("--tabor 0.8", 1e-5), ("--tabor 0.37", 1e-3), ("--tabor 7.3", 1e-4),
                                          ("--tabor 1.37 --law morse:3", 1e-4), ("--profile cone:0.3 --coupling 0.4 --outer-radius 60", 1e-4),
                                          ("--tabor 0 --radius 57", 1e-3)])
def test_the_cubics_are_the_curve(scene, error):
    """Another solve, with another tolerance and mesh, has its points on the cubics."""
    branches, _, text = law(f"{scene} --error {error}")
    preload = branches["in"][-1]
    found = document(f"solve {scene} --preload {preload[0] * 0.999} --tolerance 3e-8 --want curve,hysteresis")
    loop = found["hysteresis"]["displacement_control"]
    unit = math.sqrt(found["input"]["radius"])
    stable = {"out": [], "in": []}
    jumps = {jump["phase"]: jump["before"] for jump in loop["jumps"]}
    for point in found["curve"]:
        if not jumps:
            stable["in"].append(point)
        elif point["position"] <= jumps["loading"]["position"]:
            stable["out"].append(point)
        elif point["position"] >= jumps["unloading"]["position"]:
            stable["in"].append(point)
    assert bool(branches["out"]) == bool(jumps)
    pull_off = loop["pull_off"]["force"]
    radius_error = float(text.split("contact radius within ")[1].split(";")[0])
    compared = 0
    for branch, points in stable.items():
        knots = branches[branch]
        for point in points:
            if knots and knots[0][0] <= point["approach"] <= knots[-1][0]:
                force, _ = cubic(knots, point["approach"])
                assert abs(force - point["load"]) <= 1.01 * error * pull_off, (branch, point)
                radius, _ = cubic(knots, point["approach"], 3, 4)
                assert radius >= 0
                # where contact begins without a jump it goes as a root, of which either solve has some points
                if branches["out"] or point["contact_radius"] > 0.3 * unit:
                    assert abs(radius - point["contact_radius"] / unit) < 5e-3 + radius_error, (branch, point)
                compared += 1
    assert compared > 50
    assert knots[0][0] < knots[-1][0]
    # Nothing acts beyond the table: what is cut off is less than the error.
    assert abs((branches["out"] or branches["in"])[0][1]) <= error * pull_off
    if jumps:
        low, high = branches["in"][0][0], branches["out"][-1][0]
        assert low == pytest.approx(jumps["unloading"]["approach"], abs=1e-6)
        assert high == pytest.approx(jumps["loading"]["approach"], abs=1e-6)
        lost = area(branches["out"], low, high) - area(branches["in"], low, high)
        assert lost == pytest.approx(loop["energy_lost"], rel=1e-3, abs=3 * loop["energy_lost_error_estimate"])
    # Monotone where the curve is: between knots the derivative has the sign of the chord.
    for knots in branches.values():
        for a, b in zip(knots, knots[1:]):
            if abs(b[1] - a[1]) > 1e-3 * error * pull_off:
                for k in range(1, 10):
                    assert cubic([a, b], a[0] + k * (b[0] - a[0]) / 10)[1] * (b[1] - a[1]) >= 0


@pytest.mark.once
def test_one_table_serves_the_same_tabor_parameter():
    """Another radius, work, modulus and distance with the same Tabor parameter has the same law in reduced units."""
    first, _, _ = law("--tabor 1.37 --radius 41")
    second, _, _ = law("--tabor 1.37 --radius 370")
    w, distance = 0.0537, 3.1e-10
    for radius in 2e-8, 3e-7:
        modulus = math.sqrt(radius * w**2 / (1.37**3 * distance**3))
        si, names, text = law(f"--from-physical --modulus-pa {modulus!r} --work-j-per-m2 {w} --distance-m {distance} --radius-m {radius}")
        assert names[1:3] == ["overlap_m", "force_n"] and "R = " in text
        units = (distance, math.pi * w * radius, math.pi * w * radius / distance, math.sqrt(radius * distance))
        for branch in first:
            assert len(first[branch]) > 5
            for overlap, force, stiffness, contact, _ in si[branch]:
                x = overlap / units[0]
                if not first[branch][0][0] <= x <= first[branch][-1][0]:
                    continue
                assert abs(force / units[1] - cubic(first[branch], x)[0]) < 4e-4
                assert abs(contact / units[3] - cubic(first[branch], x, 3, 4)[0]) < 4e-3
    for branch in first:
        for x, force, _, contact, _ in second[branch]:
            if not first[branch][0][0] <= x <= first[branch][-1][0]:
                continue
            assert abs(force - cubic(first[branch], x)[0]) < 4e-4
            assert abs(contact - cubic(first[branch], x, 3, 4)[0]) < 4e-3


@pytest.mark.once
def test_what_it_says_of_other_radii():
    """The numbers of half and twice the radius are those of the Tabor parameter that these have."""
    said = expect(0, "", "contact-law --tabor 2.385 --output law.h").out
    for words, factor in (("half of R", 0.5), ("twice R", 2.0)):
        line = next(line for line in said.splitlines() if words in line)
        loop = document(f"solve --tabor {2.385 * factor**(1 / 3)!r} --want hysteresis")["hysteresis"]["displacement_control"]
        assert f"jumps in at {loop['jumps'][0]['before']['approach']:.6g}" in line.replace(";", "")[:400] or \
            abs(float(line.split("jumps in at ")[1].split(",")[0]) - loop["jumps"][0]["before"]["approach"]) < 1e-6


def test_refusals():
    two = "a contact has more than the two states, out and in, of a law with one jump each"
    expect(2, f"pulloff: loading up to approach * jumps 4 times and unloading 3 times: {two}; expected a preload below approach *, "
              "that of the second jump", "contact-law --tabor 3 --amplitude 1 --wavelength 20")
    expect(3, "pulloff: the law has no connected branch up to the preload: *", "contact-law --tabor 2 --time-limit 1e-4")
    expect(2, "pulloff: --format is lammps: expected c or csv, as only spheres *",
           "contact-law --format lammps --profile cone:0.3 --coupling 0.4 --outer-radius 60")
    expect(2, "pulloff: the preload overlaps the spheres by more than their radii: *", "contact-law --format lammps --tabor 2 --radius 3")
    expect(2, "pulloff: the attraction falls so slowly that it is 1e-06 of the pull-off force only beyond 100000 epsilon: *",
           "contact-law --error 1e-6 --profile cone:0.3 --coupling 0.4")
    expect(2, "pulloff: --format is x: expected c, csv or lammps", "contact-law --format x")
    expect(2, "pulloff: --error is 1: expected a number from 1e-6 to 0.01", "contact-law --error 1")
    expect(2, "pulloff: --name is 3a: expected letters, digits and _*", "contact-law --name 3a")
    expect(2, "pulloff: --preload is inf: expected a finite number*", "contact-law --preload inf")
    expect(2, "pulloff: --stiffness has no effect here*", "contact-law --stiffness 3")


def test_lammps():
    """Index, distance, energy, force; the force is minus the derivative of the energy."""
    branches, _, _ = law("--tabor 2.385 --radius 41")
    text = expect(0, "", "contact-law --tabor 2.385 --radius 41 --format lammps --name PAIR").out
    lines = text.splitlines()
    begin = lines.index("PAIR")
    assert all(line.startswith("#") or not line for line in lines[:begin]) and not lines[begin - 1] and not lines[begin + 2]
    word, count, kind, low, high = lines[begin + 1].split()
    rows = [[float(cell) for cell in line.split()] for line in lines[begin + 3:]]
    assert (word, kind) == ("N", "R") and len(rows) == int(count) == 10000
    assert rows[0][1] == float(low) and rows[-1][1] == float(high)
    jump = branches["out"][-1][0]
    for k, (index, distance, energy, force) in enumerate(rows):
        assert index == k + 1
        overlap = 4 * 41 - distance
        assert force == pytest.approx(cubic(branches["in" if overlap > jump else "out"], min(overlap, branches["in"][-1][0]))[0], abs=1e-9)
        if 0 < k < len(rows) - 1:
            assert distance == pytest.approx(float(low) + k * (float(high) - float(low)) / (len(rows) - 1), rel=1e-14)
            near = min(abs(4 * 41 - rows[k + d][1] - jump) for d in (-1, 0, 1))
            if near > 0.3:
                slope = (rows[k + 1][2] - rows[k - 1][2]) / (rows[k + 1][1] - rows[k - 1][1])
                assert force == pytest.approx(-slope, abs=2e-4 * max(1, abs(force)))
    assert abs(rows[-1][2]) < 1e-12 and "branch of loading alone" in text
    assert "the whole law" in expect(0, "", "contact-law --tabor 0.37 --format lammps").out


LAMMPS = """
units lj
atom_style atomic
atom_modify map array
boundary f f f
region box block -400 400 -400 400 -400 400
create_box 1 box
create_atoms 1 single 0 0 0
create_atoms 1 single 100 0 0
mass 1 1
neighbor 1 bin
PAIR
variable distance equal x[2]
variable force equal fx[2]
thermo_style custom v_distance v_force pe
thermo_modify format float %.15g norm no
"""


@pytest.mark.once
@pytest.mark.skipif(not shutil.which("lmp"), reason="LAMMPS is not installed (Debian's package lammps)")
@pytest.mark.parametrize("tabor", [2.385, 0.37])
def test_two_particles_of_lammps(tabor):
    """LAMMPS reads the file with the two lines that it names, and two particles have force and energy of the table: it interpolates
    linearly in the square of the distance. The cutoff was rounded to 10 digits, beyond the last row, and the file was refused."""
    text = expect(0, "", f"contact-law --tabor {tabor} --radius 41 --format lammps --name PAIR").out
    pathlib.Path("pair.table").write_text(text)
    lines = text.splitlines()
    commands = [line[2:].replace("FILE", "pair.table") for line in lines if line.startswith("# pair_")]
    rows = [[float(cell) for cell in line.split()] for line in lines[lines.index("PAIR") + 3:]]
    deepest = min(range(len(rows)), key=lambda k: rows[k][3])
    chosen = [rows[k] for k in (10, 300, deepest - 12, 4000, 9000)]  # LAMMPS rounds the jump off
    runs = [f"set atom 2 x {distance!r}\nrun 0" for _, distance, _, _ in chosen]
    pathlib.Path("in.pair").write_text("\n".join([LAMMPS.replace("PAIR", "\n".join(commands)), *runs]) + "\n")
    done = subprocess.run(["lmp", "-in", "in.pair", "-log", "none"], capture_output=True, text=True)
    assert len(commands) == 2 and done.returncode == 0, done.stdout + done.stderr
    said = done.stdout.splitlines()
    found = [[float(cell) for cell in said[k + 1].split()] for k, line in enumerate(said) if line.split()[:1] == ["v_distance"]]
    assert len(found) == len(chosen)
    for (distance, force, energy), (_, row_distance, row_energy, row_force) in zip(found, chosen):
        assert distance == pytest.approx(row_distance, rel=1e-12)
        assert force == pytest.approx(row_force, rel=1e-4, abs=1e-4) and energy == pytest.approx(row_energy, rel=1e-4, abs=1e-4)
    assert any(row[3] > 1 for row in chosen) and any(row[3] < -0.9 for row in chosen), chosen


COLLIDE = r"""
#include <stdio.h>
#include <stdlib.h>
#include "law.h"

static int changes; /* of the state */

/* Two particles of unit reduced mass from FAR on; velocity Verlet. Returned: their speed when they are as far apart again,
 * 0 if they stick. */
static double collide(double speed, double step) {
  double overlap = LAW_FAR, velocity = speed, stiffness, radius;
  int state = 0, leaves = 0;
  double force = law(overlap, &state, &stiffness, &radius);
  changes = 0;
  for (long k = 0; k < 400000000; ++k) {
    const double now = overlap < -20.0 ? 20.0 * step : step; /* far out the force is small and smooth */
    const double half = velocity - 0.5 * now * force;
    const int before = state;
    overlap += now * half;
    force = law(overlap, &state, &stiffness, &radius);
    changes += state != before;
    velocity = half - 0.5 * now * force;
    if (overlap < LAW_FAR)
      return -velocity;
    leaves = leaves || velocity < 0.0;
    if (leaves && velocity > 0.0)
      return 0.0; /* it turned back: it sticks */
  }
  return 0.0;
}

int main(int argc, char **argv) {
  for (int k = 2; k < argc; ++k) {
    const double left = collide(atof(argv[k]), atof(argv[1]) / (1.0 + atof(argv[k])));
    printf("%.17g %.17g %d\n", atof(argv[k]), left, changes);
  }
  return 0;
}
"""

FORCE = r"""
#include <stdio.h>
#include <stdlib.h>
#include "law.h"

int main(int argc, char **argv) {
  int state = 0;
  for (int k = 1; k < argc; ++k) {
    double stiffness, radius;
    const double force = law(atof(argv[k]), &state, &stiffness, &radius);
    printf("%.17g %.17g %.17g %d\n", force, stiffness, radius, state);
  }
  return 0;
}
"""


def compiled(source, words):
    """A program with the header of a scene, compiled without a warning."""
    said = expect(0, "", f"contact-law {words} --name law --output law.h").out
    pathlib.Path("program.c").write_text(source)
    subprocess.run([COMPILER, "-std=c99", "-O2", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "program.c", "-o", "program", "-lm"],
                   check=True)
    return said


def numbers(*words):
    done = subprocess.run(["./program", *map(repr, words)], capture_output=True, text=True, check=True)
    return [[float(word) for word in line.split()] for line in done.stdout.splitlines()]


@pytest.mark.once
@needs_compiler
def test_two_particles_collide():
    """The kinetic energy falls by what the quasi-static path of the solver loses, so that e^2 = 1 - (v_s/v)^2 with the sticking
    speed v_s = sqrt(2 E/m); from 0.2 to 20 v_s. The fast ones go beyond the table, where Hertz continues it."""
    compiled(COLLIDE, "--tabor 2.385")
    loop = document("solve --tabor 2.385 --tolerance 1e-7 --want hysteresis")["hysteresis"]["displacement_control"]
    lost = loop["energy_lost"]
    sticking = math.sqrt(2 * lost)
    step = 1e-4
    for factor in 0.2, 0.97:
        [[_, left, changes]] = numbers(step, sticking * factor)
        assert left == 0 and changes >= 1, "it sticks"
    for factor in 1.03, 1.5, 4, 20:
        [[_, left, changes]] = numbers(step, sticking * factor)
        assert changes == 2, "once in and once out"
        # 1e-3 of the energy lost, as is promised of the table, and the rounding of time steps at jumps and far out
        assert (factor * sticking) ** 2 - left**2 == pytest.approx(2 * lost, rel=2e-3), factor
        assert left / (factor * sticking) == pytest.approx(math.sqrt(1 - factor**-2), abs=4e-3 / (factor**2 - 1) ** 0.5)
    low, high = 0.98, 1.02  # the sticking speed itself
    for _ in range(5):
        middle = 0.5 * (low + high)
        [[_, left, _]] = numbers(step, sticking * middle)
        low, high = (low, middle) if left else (middle, high)
    assert 0.5 * (low + high) == pytest.approx(1, abs=1.5e-3)


@needs_compiler
def test_a_law_without_jumps_loses_nothing():
    compiled(COLLIDE, "--tabor 0.37")
    for speed in 0.05, 0.5, 5:
        [[_, left, changes]] = numbers(1e-3, speed)
        assert changes == 0 and left == pytest.approx(speed, rel=1e-4)


@pytest.mark.once
@needs_compiler
@pytest.mark.parametrize("scene", ["--tabor 2.385", SI])
def test_the_header(scene):
    """The state goes in at one jump and out at the other; beyond the table Hertz is the solver's force."""
    said = compiled(FORCE, scene)
    branches, _, _ = law(scene)
    into, out_of = branches["out"][-1][0], branches["in"][0][0]
    scale = abs(into)
    end = branches["in"][-1]
    path = [-1000 * scale, into - 1e-9 * scale, into + 1e-9 * scale, 0.5 * (into + out_of), out_of + 1e-9 * scale,
            out_of - 1e-9 * scale, 0.5 * (into + out_of), end[0]]
    found = numbers(*path)
    assert [int(state) for *_, state in found] == [0, 0, 1, 1, 1, 0, 0, 1]
    assert found[0][:3] == [0, 0, 0]
    for x, (force, stiffness, radius, state) in zip(path[1:], found[1:]):
        knots = branches["in" if state else "out"]
        wanted = cubic(knots, x)
        assert force == pytest.approx(wanted[0], rel=1e-12) and stiffness == pytest.approx(wanted[1], rel=1e-9)
        assert radius == pytest.approx(cubic(knots, x, 3, 4)[0], rel=1e-12, abs=1e-15)
    assert "Hertz with the same force and stiffness there" in said
    key, part = ("preload-load-n", "physical") if "physical" in scene else ("preload-load", None)
    harder = 6 * end[1]
    d = document(f"solve {scene} --{key} {harder!r} --want hysteresis")
    state = (d["physical"] if part else d)["hysteresis"]["displacement_control"]["preload"]
    approach, load = (state["approach_m"], state["load_n"]) if part else (state["approach"], state["load"])
    [*_, [force, *_]] = numbers(*path, approach)
    assert force == pytest.approx(load, rel=1e-3)


@pytest.mark.once
def test_errors_of_a_fixed_mesh_are_not_estimated():
    text = expect(0, "", "contact-law --tabor 1 --scheme ring --nodes 60 --outer-radius 60 --format csv").out
    assert text.count("error not estimated\n") == 3 and "nan" not in text


def test_output_and_names():
    shown = expect(0, "", "contact-law --tabor 2.385").out
    said = expect(0, "", "contact-law --tabor 2.385 --name my_law --output my.h").out
    text = pathlib.Path("my.h").read_text()
    assert "static inline double my_law(" in text and "#define MY_LAW_JUMP_IN" in text
    assert text.replace("my_law", "pulloff_law").replace("MY_LAW", "PULLOFF_LAW") == shown
    assert "holds for all pairs of particles with R w^2/(E*^2 epsilon^3) = 13.5" in said
    assert run("contact-law --tabor 2.385 --output no/such/folder.h").code == 4
    repeated = next(line for line in said.splitlines() if line.startswith("made by: pulloff ")).removeprefix("made by: pulloff ")
    assert expect(0, "", repeated).out == shown


@pytest.mark.once
@pytest.mark.parametrize("bodies", ["--modulus-pa 2e9 --radius-m 1e-7", "--young-pa 3e9,6e9 --poisson 0.3,0.4 --radius-m 1e-7,3e-7"])
def test_the_command_in_si_units_repeats_the_law(bodies):
    shown = expect(0, "", f"contact-law --from-physical {bodies} --work-j-per-m2 0.05 --distance-m 3e-10 --error 1e-3 --format csv").out
    repeated = next(line for line in shown.splitlines() if line.startswith("# made by: pulloff ")).removeprefix("# made by: pulloff ")
    assert bodies.split()[0] in repeated
    assert expect(0, "", repeated).out == shown


@pytest.mark.once
@pytest.mark.parametrize("more, warns", [("--distance-m 3e-10", True), ("--distance-m 3e-10 --profile exact_sphere:2e-8", False),
                                         ("--distance-m 3e-10 --modulus-pa 2e9", False)])
def test_a_contact_too_wide_for_a_parabola_is_warned_of(more, warns):
    """The soft tip: by JKR theory the parabola pulls 32 % more than the sphere. A stiff one, or the sphere itself, has no warning."""
    modulus = "" if "modulus" in more else "--modulus-pa 6.67e6"
    done = run(f"contact-law --from-physical {modulus} --work-j-per-m2 0.03 --error 1e-2 {more}" + ("" if "exact" in more else " --radius-m 2e-8"))
    assert done.code == 0
    assert ("pulls 32 % more than a sphere; --profile exact_sphere:2e-08 is the sphere" in done.err) == warns and ("warning" in done.err) == warns


def summary(folder):
    lines = pathlib.Path(folder, "summary.csv").read_text().splitlines()
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def macro(text, name):
    found = [line for line in text.splitlines() if line.startswith(f"#define {name} ")]
    return float(found[0].split("(")[1].rstrip(")")) if found else math.nan


def test_sets():
    """Each row has the file and the numbers of a command of its own, in any number of threads; a refused scene is a row."""
    rows = ["1.37,0.21,17,-", "2.911,1.4,20,30", "0.44,-,-,-", "3.1,0.13,-1,-"]
    pathlib.Path("sets.csv").write_text("tabor,amplitude,wavelength,radius\n" + "\n".join(rows) + "\n")
    said = expect(0, "", "contact-law --sets sets.csv --error 1e-3 --name pair --output one -j1").out
    assert said.startswith("2 laws in one, with summary.csv\n2 rows have no law, the first is row 2: loading up to approach")
    assert expect(0, "", "contact-law --sets sets.csv --error 1e-3 --name pair --output two -j2").out == said.replace("in one", "in two")
    found, other = summary("one"), summary("two")
    assert [{**row, "seconds": ""} for row in found] == [{**row, "seconds": ""} for row in other]
    assert [row["status"] for row in found] == ["ok", "bad_input", "ok", "bad_input"]
    assert sorted(path.name for path in pathlib.Path("one").iterdir()) == ["laws.jsonl", "pair_1.h", "pair_3.h", "summary.csv"]
    for row, cells in zip(found, rows):
        words = [f"--{key} {cell}" for key, cell in zip(("tabor", "amplitude", "wavelength", "radius"), cells.split(",")) if cell != "-"]
        alone = run(f"contact-law {' '.join(words)} --error 1e-3 --name pair_{row['row']}")
        assert ",".join(row[key] for key in ("tabor", "amplitude", "wavelength", "radius")) == cells
        if row["status"] != "ok":
            assert alone.code == 2 and alone.err.replace("--", "") == f"pulloff: {row['reason']}\n" and row["file"] == "-"
            assert math.isnan(float(row["pull_off_force"]))
            continue
        text = pathlib.Path("one", row["file"]).read_text()
        assert text == alone.out == pathlib.Path("two", row["file"]).read_text() and row["reason"] == "-"
        for column, name in (("jump_in", "JUMP_IN"), ("jump_out", "JUMP_OUT"), ("pull_off_force", "PULL_OFF"), ("energy_lost", "ENERGY_LOST")):
            assert float(row[column]) == pytest.approx(macro(text, f"PAIR_{row['row']}_{name}"), rel=1e-12, nan_ok=True)
        assert f"force within {float(row['force_error']):.1e} of" in text and 0 < float(row["seconds"]) < 600
    assert float(found[0]["jump_out"]) < float(found[0]["jump_in"]) and math.isnan(float(found[2]["jump_in"]))


def test_sets_in_si_units():
    """Cells with a list, numbers that a row does not give, units of the columns; a contact too wide for a parabola is warned of."""
    pathlib.Path("sets.csv").write_text("radius_m,modulus_pa,law\n1e-7;3e-7,2e9,-\n2e-8,6.67e6,morse:3\n-1,2e9,-\n")
    words = "--from-physical --work-j-per-m2 0.03 --distance-m 3e-10 --error 1e-2 --format csv"
    done = run(f"contact-law {words} --sets sets.csv --output laws")
    assert done.code == 0 and "in 1 of 3 rows the contact is so wide" in done.err and "in row 2 by 32 %" in done.err
    found = summary("laws")
    assert [row["status"] for row in found] == ["ok", "ok", "bad_input"] and found[2]["reason"].startswith("radius_m is -1: expected")
    for row, scene in zip(found, ("--radius-m 1e-7,3e-7 --modulus-pa 2e9", "--radius-m 2e-8 --modulus-pa 6.67e6 --law morse:3")):
        alone = run(f"contact-law {words} {scene} --name {row['file'][:-4]}").out
        assert pathlib.Path("laws", row["file"]).read_text() == alone
        forces = [float(line.split(",")[2]) for line in alone.splitlines() if line.startswith("in,")]
        assert float(row["pull_off_force_n"]) == pytest.approx(-min(forces), rel=0.02)
        assert 0 < float(row["energy_lost_j"]) and float(row["jump_out_m"]) < float(row["jump_in_m"]) < 0


@pytest.mark.parametrize("columns, cells, words, alone", [
    ("alpha,amplitude", "0.05,0.02", "--tabor 1.5", f"--tabor 1.5 --amplitude 0.02 --wavelength {math.sqrt(0.02 * 100 / 0.05)!r}"),
    ("amplitude_ratio,wavelength", "0.004,15", "--tabor 1.5", "--tabor 1.5 --amplitude 0.06 --wavelength 15"),
    ("outer_ratio", "0.5", "--tabor 1.5", "--tabor 1.5 --outer-radius 50"),
    ("amplitude_ratio,wavelength_m", "0.0078125,5.12e-9", "--from-physical --modulus-pa 1e9 --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 3e-8",
     "--from-physical --modulus-pa 1e9 --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 3e-8 --amplitude-m 4e-11 --wavelength-m 5.12e-9"),
])
def test_sets_of_groups(columns, cells, words, alone):
    """Columns of dimensionless groups were refused. Each sets the key that it belongs to; the command in the file is one of this verb."""
    pathlib.Path("sets.csv").write_text(f"{columns}\n{cells}\n")
    expect(0, "", f"contact-law --sets sets.csv --error 1e-2 --format csv --output laws {words}")
    law = pathlib.Path("laws/pulloff_law_1.csv").read_text()
    assert law == expect(0, "", f"contact-law --error 1e-2 --format csv --name pulloff_law_1 {alone}").out
    [again] = [line.split("pulloff ", 1)[1] for line in law.splitlines() if "pulloff contact-law" in line]
    assert expect(0, "", f"{again} --name pulloff_law_1").out == law


def test_sets_go_on():
    """What is in the folder, whole and made from the same row and options, is not made again."""
    def make(rows, words=""):
        pathlib.Path("sets.csv").write_text("tabor,amplitude,wavelength,radius\n" + "\n".join(rows) + "\n")
        said = expect(0, "", f"contact-law --sets sets.csv --error 1e-2 --output laws -j1 {words}").out
        kept = [line for line in said.splitlines() if "already, made from the same row" in line]
        files = {path.name: path.read_bytes() for path in pathlib.Path("laws").glob("*.h")}
        return int(kept[0].split()[0]) if kept else 0, files, summary("laws")
    rows = ["1,-,-,-", "2.911,1.4,20,30", "0.3,-,-,-"]
    none, files, first = make(rows)
    assert none == 0 and sorted(files) == ["pulloff_law_1.h", "pulloff_law_3.h"] and first[1]["status"] == "bad_input"
    assert make(rows) == (3, files, first)  # seconds, too: those of the solves
    # A file that was altered or lost, a line that was altered, and the beginning of one
    pathlib.Path("laws/pulloff_law_1.h").write_bytes(files["pulloff_law_1.h"][:-100])
    assert make(rows)[:2] == (2, files)
    pathlib.Path("laws/pulloff_law_3.h").unlink()
    assert make(rows)[:2] == (2, files)
    store = pathlib.Path("laws/laws.jsonl")
    lines = store.read_text().splitlines()
    store.write_text("\n".join([lines[0].replace('"pull_off":1.', '"pull_off":2.'), *lines[1:3], lines[3][:60]]))
    assert make(rows)[:2] == (2, files)
    # Another row and other options
    assert make(["1,-,-,-", "2.911,1.4,20,30", "0.31,-,-,-"])[0] == 2
    assert make(rows, "--error 5e-3")[0] == 0
    assert make(rows, "--name other")[0] == 0
    assert make(rows, "--preload-load 5")[0] == 0
    # A profile whose file changed
    for depth in 1, 1, 1.1:
        pathlib.Path("tip.csv").write_text("r,gap\n" + "".join(f"{k},{depth * k * k / 200}\n" for k in range(60)))
        kept = make(["1,-,-,-"], "--profile-file tip.csv --preload 2 --name tip")[0]
        assert kept == (depth == 1 and "tip" in files)
        files["tip"] = b""


@pytest.mark.parametrize("code, message, table, words", [
    (2, "--output is missing: expected a folder for the laws of --sets", "tabor\n1\n", ""),
    (2, "sets.csv:1: the column tabor is given, too: expected it or --tabor", "tabor\n1\n", "--output laws --tabor 2"),
    (2, "sets.csv:1: the column stiffness has no effect on a law: *", "stiffness\n1\n", "--output laws"),
    (2, "sets.csv:1: the column radius_m is in SI units: expected --from-physical beside --sets", "radius_m\n1\n", "--output laws"),
    (2, "sets.csv:1: the column taber is unknown: expected names of keys", "taber\n1\n", "--output laws"),
    (2, "sets.csv has no rows: *", "tabor\n", "--output laws"),
    (2, "no row of sets.csv has a law; row 1: tabor is -1: expected a finite number >= 0", "tabor\n-1\n", "--output laws"),
    (3, "no row of sets.csv has a law; row 1: the law has no connected branch *", "tabor\n2\n", "--output laws --time-limit 1e-4"),
    (2, "--jobs is x: expected a whole number, 0 for all cores", "tabor\n1\n", "--output laws -j x"),
    (4, "*sets.csv/laws*", "tabor\n1\n", "--output sets.csv/laws"),
])
def test_messages_of_sets(code, message, table, words):
    pathlib.Path("sets.csv").write_text(table)
    expect(code, f"pulloff: {message}", f"contact-law --sets sets.csv {words}")


def test_jobs_need_sets():
    expect(2, "pulloff: --jobs has no effect without --sets", "contact-law --tabor 1 -j2")


def test_sets_that_are_interrupted():
    """The summary has the rows so far; the others are interrupted."""
    pathlib.Path("sets.csv").write_text("tabor\n" + "".join(f"{0.3 + k / 200}\n" for k in range(60)))
    words = [conftest.PROGRAM, "contact-law", "--sets", "sets.csv", "--output", "laws", "--error", "1e-2", "-j1"]
    with subprocess.Popen(words, stderr=subprocess.PIPE, text=True) as process:
        while process.poll() is None and not pathlib.Path("laws/pulloff_law_01.h").exists():
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        _, said = process.communicate()
    states = [row["status"] for row in summary("laws")]
    assert process.returncode == 130 and "laws/summary.csv has " in said
    assert len(states) == 60 and states[0] == "ok" and states[-1] == "interrupted" and set(states) == {"ok", "interrupted"}
    # The same command, of which ten rows suffice, goes on there.
    pathlib.Path("sets.csv").write_text("".join(pathlib.Path("sets.csv").read_text().splitlines(True)[:11]))
    done = states[:10].count("ok")
    said = expect(0, "", "contact-law --sets sets.csv --output laws --error 1e-2 -j1").out
    assert said.startswith("10 laws in laws") and (f"{done} row" in said.splitlines()[1] or len(states) > 99)
