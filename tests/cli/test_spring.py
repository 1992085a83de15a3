"""Loading and unloading through a spring: where it jumps, what it loses, and its units. Its closed forms and staircases are in
tests/harness/test_hysteresis.c."""

import math
import random

import pytest
from conftest import ROOT, document, rows_of, run


def loops(words, *more):
    return document(f"solve {words} --want hysteresis,curve", *more)["hysteresis"]


def base(state, stiffness):
    return state["approach"] + state["load"] / stiffness


def jumps(loop):
    """Those that are seen: near a flat extremum the rounding of the trace makes jumps of some 1e-6."""
    return [jump for jump in loop["jumps"]
            if None in (jump["before"]["approach"], jump["after"]["approach"])
            or abs(jump["before"]["approach"] - jump["after"]["approach"]) > 1e-2]


def same(ours, theirs, tolerance):
    return math.isclose(ours, theirs, rel_tol=tolerance, abs_tol=tolerance)


def test_stated_errors_hold_and_the_energy_balance_closes():
    """The work done by the base in a cycle is the sum of what the jumps lose; random stiffnesses."""
    numbers = random.Random(7)
    for _ in range(5):
        scene = f"--tabor {10**numbers.uniform(-1, 0.7):.4g} --stiffness {10**numbers.uniform(-4, 1):.4g}"
        if numbers.random() < 0.5:
            scene += f" --amplitude {10**numbers.uniform(-1, 0.3):.3g} --wavelength {numbers.uniform(8, 40):.3g}"
        loose, tight = (loops(f"{scene} --tolerance {tolerance}")["spring"] for tolerance in ("1e-4", "1e-8"))
        assert len(loose["jumps"]) == len(tight["jumps"]), scene
        for ours, theirs in [(loose, tight), *zip(loose["jumps"], tight["jumps"])]:
            bound = ours["energy_lost_error_estimate"] + theirs["energy_lost_error_estimate"]
            assert theirs["energy_lost"] >= 0, scene
            assert abs(ours["energy_lost"] - theirs["energy_lost"]) <= bound + 1e-12, scene
        assert abs(tight["work"] - tight["energy_lost"]) <= 1e-6 * (1 + tight["energy_lost"]), scene


def test_stability_at_a_given_base():
    """One more mode is unstable where base and approach move against each other along the branch."""
    scene, stiffness = "--tabor 3 --amplitude 1 --wavelength 20", 0.3
    whole = document(f"solve {scene} --want hysteresis,curve --stiffness {stiffness}")
    curve = whole["curve"]
    wrong = 0
    for point, following in zip(curve, curve[1:]):
        against = (base(following, stiffness) - base(point, stiffness)) * (following["approach"] - point["approach"]) < 0
        wrong += point["unstable_modes_at_base"] != point["unstable_modes"] + against
    turns = sum((b["approach_rate"] + b["load_rate"] / stiffness) * (a["approach_rate"] + a["load_rate"] / stiffness) < 0
                for a, b in zip(curve, curve[1:]))
    assert wrong <= turns, "only where the base turns between two points"
    for jump in jumps(whole["hysteresis"]["spring"]):
        ahead = [p for p in curve if p["position"] > jump["before"]["position"] + 1e-3]
        behind = [p for p in curve if p["position"] < jump["before"]["position"] - 1e-3]
        stable, unstable = (behind[-1], ahead[0]) if jump["phase"] == "loading" else (ahead[0], behind[-1])
        assert stable["unstable_modes_at_base"] == 0 < unstable["unstable_modes_at_base"]
    for fold in whole["folds"]:  # just after a fold
        near = next(p for p in curve if p["position"] > fold["position"])
        assert fold["unstable_modes_at_base"] == near["unstable_modes_at_base"]
    assert "unstable_modes_at_base" not in document(f"solve {scene} --want curve")["curve"][0]
    table = run(f"solve {scene} --stiffness {stiffness} --curve -").out
    assert "energy_error,unstable_modes_at_base\n" in table


def relaxed():
    """The loops of reference/spring_jumps.csv: a relaxation in time while the base is moved; no branch is followed."""
    found = {}
    for row in rows_of(ROOT / "reference/spring_jumps.csv"):
        key = tuple(row[name] for name in ("tabor", "amplitude", "wavelength", "radius", "outer_radius", "stiffness", "preload_load"))
        found.setdefault(key, []).append(row)
    return sorted(found.items())


@pytest.mark.parametrize("key, rows", relaxed(), ids=lambda value: " ".join(value) if isinstance(value, tuple) else "")
def test_jumps_are_those_of_a_relaxation_in_time(key, rows):
    names = "tabor", "amplitude", "wavelength", "radius", "outer-radius", "stiffness", "preload-load"
    smooth = float(key[1]) == 0
    words = " ".join(f"--{name} {value}" for name, value in zip(names, key) if not (smooth and name in ("amplitude", "wavelength")))
    ours = jumps(loops(words)["spring"])
    assert [jump["phase"] for jump in ours] == [row["phase"] for row in rows]
    for jump, row in zip(ours, rows):
        found = {"base": base(jump["before"], float(key[5])), "load_before": jump["before"]["load"],
                 "load_after": jump["after"]["load"], "energy_lost": jump["energy_lost"]}
        for name, value in found.items():
            assert abs(value - float(row[name])) <= float(row[name + "_uncertainty"]), (name, value, row)


def test_units():
    tip = ("solve --from-physical --modulus-pa 5e9 --work-j-per-m2 0.08 --distance-m 3e-10 --radius-m 3e-8")
    found = document(f"{tip} --preload-load-n 2e-9 --stiffness-n-per-m 2")
    force, length = math.pi * 0.08 * 3e-8, 3e-10
    assert same(found["input"]["preload_load"], 2e-9 / force, 1e-14)
    assert same(found["hysteresis"]["spring"]["stiffness"], 2 * length / force, 1e-14)
    assert same(found["hysteresis"]["spring"]["preload"]["load"], 2e-9 / force, 1e-9)
    # a profile without a radius has another unit of load
    unit = loops("--profile cone:0.3 --coupling 2 --outer-radius 30 --tolerance 1e-3 --stiffness 0.5")
    assert same(unit["spring"]["stiffness"], 0.5, 1e-15)


@pytest.mark.parametrize("scene", [
    "--profile truncated:11.2791,21.2786 --coupling 0.0464727 --law mie:29.7302,40.8253 --stiffness 0.010891",
    "--profile truncated:7.2522,90.9725 --coupling 0.00363305 --outer-radius 127.063 --stiffness 6.66004e-05",
    "--law morse:1.90529 --profile sphere --coupling 0.0238629 --radius 44.5629 --stiffness 0.000211784",
    "--law morse:4.21539 --profile power:7.50255e-05,4.018 --coupling 0.000324029 --outer-radius 58.9252 --stiffness 0.00813604"])
def test_a_jump_from_far_away_loses_what_is_stated(scene):
    """A soft spring jumps into contact on a segment along which the attraction grows manifold. The error of the place
    where it jumps was taken as that for which the points are chosen: 134.1478 was stated with 0.0022, and is 134.1405."""
    loose, tight = (document(f"solve {scene} --want hysteresis --tolerance {t}")["hysteresis"]["spring"] for t in ("1e-4", "1e-8"))
    assert len(loose["jumps"]) == len(tight["jumps"])
    for ours, theirs in zip(loose["jumps"], tight["jumps"]):
        off = abs(ours["energy_lost"] - theirs["energy_lost"])
        assert off <= ours["energy_lost_error_estimate"] + theirs["energy_lost_error_estimate"]
        assert ours["energy_lost_error_estimate"] < 0.02 * ours["energy_lost"]


def test_the_error_of_a_loss_is_not_that_of_the_farthest_approach():
    """A cantilever jumps out of contact to 970 epsilon. The bound of the far field grew with that distance, though a
    bound of the energy itself is 1e-8 of it: 4.2 zJ were stated where the loss is off by less than 0.02 zJ."""
    spring = document("solve --from-physical --radius-m 5e-9 --modulus-pa 1e11 --work-j-per-m2 0.05 --distance-m 1.6e-10"
                      " --stiffness-n-per-m 0.01 --want hysteresis")["hysteresis"]["spring"]
    last = spring["jumps"][-1]
    assert last["after"]["approach"] < -900.0
    assert last["energy_lost_error_estimate"] < 1e-6 * last["energy_lost"]
