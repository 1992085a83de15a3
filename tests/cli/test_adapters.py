"""An example solver of reference/solvers conforms, on a coarse mesh, and solves a scene of the case smoke within its tolerances; the
deliberately wrong one does not, and its mistake is named. The one in GNU Octave is tested where Octave is installed."""

import pathlib
import shutil

import pytest
from conftest import ROOT, expect


@pytest.fixture(autouse=True)
def _data(monkeypatch):
    monkeypatch.setenv("PULLOFF_DATA", str(ROOT))


def manifest(solver):
    return ROOT / f"reference/solvers/{solver}.yaml"


@pytest.mark.parametrize("solver, knob", [("newton", 126), ("triangles", 126), ("copson", 1), ("relax", 126), ("paper", 251)])
def test_conforms(solver, knob):
    if solver == "paper" and not shutil.which("octave-cli"):
        pytest.skip("Octave is not installed")
    expect(0, "", f"conform {manifest(solver)} --knob {knob} --output out")


@pytest.mark.parametrize("solver, knob", [("newton", 501), ("triangles", 501), ("copson", 1)])
def test_solves_smoke(solver, knob):
    expect(0, None, f"verify smoke --points 2 --solver {manifest(solver)} --knob {knob} --output out --jobs 1").has(
        r"^[1-9][0-9]* checks pass( \([0-9]* slack\))?, 0 do not")


CASE = """name: own
title: A wavy sphere
suites: [own]
scene: {{tabor: {}, radius: 100, outer_radius: 100, scheme: panel}}
want: [pull_off, hysteresis]
checks:
  - {{quantity: {}, tolerance: {}, kind: abs, because: {}}}
"""
# On a mesh that does not resolve the contact edge, the branch has dozens of spurious folds. A step that ends on another part of it must not
# turn the continuation back.
FOLDS = CASE.format("5, amplitude: 10, wavelength: 20, approach_start: -15, approach_end: 12", "pull_off_force, reference: reference/wavy_pull_off.csv",
                    0.31, "the error of 125 elements is 0.2995").replace(", hysteresis", "")
# A jump over unstable stretches of the branch ends at a state of rest.
JUMPS = CASE.format("4, amplitude: 0.4, wavelength: 10, preload: 4", "jumps, reference: reference/wavy_jumps.csv", 0.12,
                    "250 elements resolve the contact edge only coarsely") + """\
  - {quantity: hysteresis_force, reference: reference/wavy_loops.csv, tolerance: 0.01, kind: abs, because: the error of 250 elements is half of this}
"""


@pytest.mark.parametrize("solver, knob, case", [("newton", 126, FOLDS), ("triangles", 126, FOLDS), ("relax", 251, JUMPS)],
                         ids=["newton", "triangles", "relax"])
def test_passes_over_folds_and_jumps(solver, knob, case):
    pathlib.Path("own.yaml").write_text(case)
    expect(0, None, f"verify own.yaml --solver {manifest(solver)} --knob {knob} --output out")


def test_wrong():
    expect(1, "", f"conform {manifest('wrong')} --knob four_thirds --output out").has(
        "^wrong *force at pull-off: the expected value times 4/3 in 4 scenes")
