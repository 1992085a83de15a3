"""pulloff theory after a preload, at a load, at an approach and along the curve. What is expected comes from formulas of the
literature, and from Eq 5 as numpy and scipy evaluate it on a dense grid of contact radii."""

import csv
import math
import random

import numpy as np
import pytest
from conftest import document, expect, run
from scipy.special import struve


def scene(tabor, radius, amplitude=0.0, wavelength=1.0):
    """Load (pi w R) and approach (epsilon) of Eq 5 at contact radii, with e = E* epsilon/w = sqrt(R/mu^3)."""
    e, k = math.sqrt(radius / tabor**3), 2 * math.pi / wavelength

    def state(a):
        x = k * a
        first = x * struve(0, x)
        wave = amplitude * (first - struve(1, x))
        load = 4 * e * a**3 / (3 * math.pi * radius**2) + e * wave * a / radius - np.sqrt(8 * e * a**3 / math.pi) / radius
        approach = a**2 / radius + amplitude * math.pi / 2 * first - np.sqrt(2 * math.pi * a / e)
        return load, approach
    return state


def jkr(tabor, radius, load):
    """The contact radius of Johnson, Kendall and Roberts 1971 at a load, from their solution of the quadratic equation."""
    e = math.sqrt(radius / tabor**3)
    stable = (math.sqrt(1.5) + math.sqrt(load + 1.5))**2  # a^3 = (3 R/4 E*) (sqrt(P0) + sqrt(P + P0))^2, P0 = 1.5 pi w R
    return (0.75 * math.pi * radius**2 / e * stable)**(1 / 3)


@pytest.mark.parametrize("tabor, radius, load", [(3, 100, 0), (3, 100, -1.5), (0.7, 31.7, -0.3), (5, 1e4, 2.385), (20, 300, 50)])
def test_the_contact_radius_of_a_smooth_sphere_at_a_load(tabor, radius, load):
    words = f"--tabor {tabor} --radius {radius} --load {load}"
    d = document("theory jkr " + words)
    a = jkr(tabor, radius, load)
    # where the curve turns, the radius is known to the root of the rounding of the load
    assert d["load"] == load and abs(d["contact_radius"] / a - 1) < (2e-8 if load == -1.5 else 1e-13)
    assert abs(d["approach"] - scene(tabor, radius)(a)[1]) < 1e-7 * tabor
    again = document(f"theory guduru --amplitude 0 {words}")
    assert again["contact_radius"] == pytest.approx(d["contact_radius"], rel=1e-13)
    dmt = document("theory dmt " + words)  # Hertz under the load and the attraction
    assert dmt["contact_radius"] == pytest.approx((0.75 * math.pi * radius**2 * (load + 2) / math.sqrt(radius / tabor**3))**(1 / 3), rel=1e-13)


def test_the_force_of_a_smooth_sphere_at_an_approach():
    d = document("theory jkr --tabor 3 --approach 0")
    assert d["load"] == pytest.approx(-4 / 3, abs=1e-13), "where the sphere just touches (Johnson 1985): 8/9 of the pull-off force"
    assert document("theory dmt --tabor 3 --approach 0.36")["contact_radius"] == pytest.approx(6, rel=1e-14)


@pytest.mark.parametrize("held, value", [("load", 0.385), ("load", -1.4), ("approach", -3.85), ("approach", 1.385)])
def test_maugis_is_the_outermost_state(held, value):
    """It is the state that --contact-radius evaluates, and no larger contact has the load or the approach."""
    d = document(f"theory maugis --tabor 2.385 --{held} {value}")
    a = d["contact_radius"]
    at = [document(f"theory maugis --tabor 2.385 --contact-radius {a * f}")[held] for f in (1, 1 + 1e-4, 1.1, 1.5, 2, 4)]
    assert at[0] == pytest.approx(value, abs=1e-12) and value < at[1] < at[2] < at[3] < at[4] < at[5]
    jkr_state, soft = (document(f"theory {form} --tabor 200 --{held} {value if held == 'load' else 40 * value}") for form in ("jkr", "maugis"))
    assert soft["contact_radius"] == pytest.approx(jkr_state["contact_radius"], rel=1e-4), "the limit of soft bodies"


def random_scenes(count):
    """Some with compact contact, others with grooves that the sphere jumps over."""
    rng = random.Random(20200827)
    for _ in range(count):
        tabor, radius = 10**rng.uniform(0, 1.3), 10**rng.uniform(2, 4)
        size = (radius**2 / math.sqrt(radius / tabor**3))**(1 / 3)  # about the contact radius
        wavelength = size * 10**rng.uniform(-0.9, 0.2)
        amplitude = wavelength**2 / radius * 10**rng.uniform(-1.7, -0.3)
        yield rng, tabor, radius, amplitude, wavelength


def after_preload(loads, approaches, preload):
    """Loading at given approach up to a load, and back, over a grid: the sphere stands where the approach is greater than at
    every smaller contact radius, and on the way back less than at every larger one. Returns the reversal and the pull-off."""
    standing = np.maximum.accumulate(np.maximum(approaches, 0)) <= approaches
    reached = int(np.argmax(standing & (loads >= preload)))
    back = np.minimum.accumulate(approaches[reached::-1])[::-1] >= approaches[:reached + 1]
    least = np.flatnonzero(back)[np.argmin(loads[:reached + 1][back])]
    return reached, least


@pytest.mark.once
def test_eq_5_after_a_preload():
    """The steps of the grid decide how well the two agree. A scene in which another grid has another jump is left out; they
    are few."""
    checked = jumps = 0
    for rng, tabor, radius, amplitude, wavelength in random_scenes(30):
        preload, state = 10**rng.uniform(-1, 1), scene(tabor, radius, amplitude, wavelength)
        d = document(f"theory guduru --tabor {tabor} --radius {radius} --amplitude {amplitude} --wavelength {wavelength} "
                     f"--preload-load {preload} --load {-0.3 * 1.5}")
        end = 2.5 * max(d["reversal_contact_radius"], d["pull_off_contact_radius"])
        found = []
        for points in (6_001, 6_901):
            a = np.linspace(0, end, points)[1:]
            load, approach = state(a)
            reached, least = after_preload(load, approach, preload)
            inside = np.flatnonzero(load[:reached + 1] <= -0.45)
            found.append((load[reached], approach[reached], a[reached], -load[least], approach[least], a[least], a[inside[-1]]))
            steps = [np.abs(np.diff(column[max(0, k - 2):k + 3])).max() for k in (reached, least) for column in (load, approach, a)]
            steps.append(3 * a[0])
        if not np.allclose(*found, rtol=0.03, atol=0.03):
            continue
        checked += 1
        jumps += d["loading_jumps"] > 1
        keys = ("reversal_load", "reversal_approach", "reversal_contact_radius", "after_preload_force", "after_preload_approach",
                "after_preload_contact_radius", "contact_radius")
        assert np.all(np.abs(np.array([d[key] for key in keys]) - found[1]) <= 2 * np.array(steps) + 1e-12), (d, found, steps)
        exact = state(np.array([d["reversal_contact_radius"], d["after_preload_contact_radius"]]))
        assert exact[0] == pytest.approx([d["reversal_load"], -d["after_preload_force"]], rel=1e-10, abs=1e-10)
        assert exact[1] == pytest.approx([d["reversal_approach"], d["after_preload_approach"]], rel=1e-10, abs=1e-10 * amplitude)
        assert d["after_preload_force"] <= d["pull_off_force"] * (1 + 1e-12)
    assert checked >= 27 and jumps >= 5, (checked, jumps)


def test_compare_evaluates_the_same_preload():
    words = "--tabor 5 --amplitude 2 --wavelength 20 --preload-load 1"
    rows = document("compare " + words)["theories"]
    force = next(row["force"] for row in rows if row["theory"] == "guduru")
    assert document("theory guduru " + words)["after_preload_force"] == pytest.approx(force, rel=1e-9)


def test_preloads_that_are_too_weak_and_hard():
    words = "theory guduru --tabor 5 --amplitude 2 --wavelength 20 "
    weak, hard, any_preload = (document(words + more) for more in ("--preload 1", "--preload 50", ""))
    assert weak["after_preload_force"] < hard["after_preload_force"] == pytest.approx(any_preload["pull_off_force"], rel=1e-13)
    assert document(words + "--preload inf") | {"digest": ""} == any_preload | {"digest": ""}, "inf stands for any preload"
    apart = document(words + "--preload -1")
    assert (apart["after_preload_force"], apart["reversal_load"], apart["reversal_contact_radius"], apart["loading_jumps"]) == (0, 0, 0, 0)
    loading = document(words + "--preload-load 0.5 --load 0.5")
    assert loading["contact_radius"] == pytest.approx(loading["reversal_contact_radius"], rel=1e-12), "the state of loading"


def test_in_si_units():
    gelatin = "--from-physical --modulus-pa 7e5 --work-j-per-m2 0.03 --distance-m 3e-10 --radius-m 0.0125"
    smooth = document(f"theory jkr {gelatin} --load-n 0")["physical"]
    assert smooth["contact_radius_m"] == pytest.approx((4.5 * math.pi * 0.03 * 0.0125**2 / 7e5)**(1 / 3), rel=1e-13)
    assert smooth["input"]["load_n"] == 0
    wavy = document(f"theory guduru {gelatin} --amplitude-m 2e-6 --wavelength-m 5e-4 --preload-load-n 2e-3")["physical"]
    assert 1.5 * math.pi * 0.03 * 0.0125 < wavy["after_preload_force_n"] < 5e-3 and wavy["reversal_load_n"] == pytest.approx(2e-3)


@pytest.mark.parametrize("form", ["jkr --tabor 3", "dmt --tabor 3", "maugis --tabor 3", "guduru --tabor 5 --amplitude 2 --wavelength 20 --preload-load 1",
                                  "jkr --wave 1,20 --wave 0.2,7 --tabor 5", "jkr --profile truncated:3,10 --coupling 0.05"])
def test_curve(form, tmp_path):
    file = tmp_path / "curve.csv"
    expect(0, "", f"theory {form} --curve", file)
    lines = [line for line in file.read_text().splitlines() if not line.startswith("#")]
    points = [{key: float(cell) for key, cell in row.items()} for row in csv.DictReader(lines)]
    assert len(points) > 150 and points[0]["contact_radius"] == 0
    assert run(f"theory {form} --curve -").out.splitlines()[4:] == lines
    d = document("theory " + form)
    assert any(p["load"] == pytest.approx(-d["pull_off_force"], rel=1e-12) for p in points), "the pull-off is a point"
    if "reversal_load" in d:
        assert points[-1]["load"] == pytest.approx(d["reversal_load"], rel=1e-12)
    for here, after in zip(points[1:], points[2:]):
        assert here["contact_radius"] < after["contact_radius"]
        assert (here["stable_at_load"] == 1) == (after["load"] > here["load"]), (here, after)
        assert (here["stable_at_approach"] == 1) == (after["approach"] > here["approach"]), (here, after)
    middle = points[len(points) // 2]
    there = document(f"theory {form} --contact-radius {middle['contact_radius']!r}")
    assert (there["load"], there["approach"]) == pytest.approx((middle["load"], middle["approach"]), rel=1e-12)


def test_curve_in_si_units(tmp_path):
    words = "theory jkr --from-physical --modulus-pa 2e9 --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 1e-7"
    out = run(words + " --curve -").out.splitlines()
    names = next(line for line in out if not line.startswith("#")).split(",")
    assert names == ["approach_nm", "load_nN", "contact_radius_nm", "stable_at_approach", "stable_at_load"]
    least = min(float(line.split(",")[1]) for line in out[5:])
    assert least == pytest.approx(-1.5 * math.pi * 0.05 * 1e-7 * 1e9, rel=1e-12)
    for words in (words, "theory maugis --tabor 1 --wave 0.01,20 --wave 0.02,7 --tension 0.9"):
        out = run(words + " --curve -").out
        command = next(line for line in out.splitlines() if line.startswith("# command: pulloff ")).removeprefix("# command: pulloff ")
        assert run(command).out == out, "the command in the header repeats the table"


def test_what_is_assumed():
    form = "guduru --tabor 5 --amplitude 2 --wavelength 20"
    assumes = document(f"theory {form} --preload 50 --load 0")["assumes"]
    assert assumes["source"].startswith("Eq 5") and "loading" in assumes["preload"] and "after the preload" in assumes["branch"]
    assert document("theory lennard-jones")["assumes"] | {"source": ""} == {"source": "", "preload": None, "branch": None}
    text = run(f"theory {form}").out
    assert text.startswith("theory   Eq 5") and "\npreload  any" in text and "\nbranch" not in text
    alone, more = document(f"theory {form}"), run(f"theory {form}").out
    assert f"digest   {alone['digest']}" in more


@pytest.mark.parametrize("message, words", [
    ("the JKR theory has no stable state at load -1.6: the lowest of all states is -1.5", "jkr --tabor 3 --load -1.6"),
    ("the JKR theory has no stable state at approach -9: the lowest of all states is -4.8*", "jkr --tabor 3 --approach -9"),
    ("DMT has no contact at load -2.1: expected at least -2", "dmt --load -2.1"),
    ("Maugis-Dugdale has no stable state at load -1.6", "maugis --tabor 3 --load -1.6"),
    ("the JKR theory has no stable state at load 3: expected at most that of the preload, 1",
     "guduru --tabor 5 --amplitude 1 --wavelength 20 --preload-load 1 --load 3"),
    ("more than one of load, approach and contact radius is given: *", "jkr --load 0 --approach 0"),
    ("more than one of load, approach and contact radius is given: *", "jkr --load 0 --contact-radius 3"),
    ("--load has no effect on theory bradley: expected only --approach", "bradley --load 0"),
    ("--load has no effect on theory kesari-lew: *", "kesari-lew --amplitude 1 --wavelength 9 --load 0"),
    ("--preload has no effect on theory dmt: expected only --tabor, --coupling, --radius, --load, --approach, --contact-radius or --curve",
     "dmt --preload 1"),
    ("--preload-load has no effect on theory maugis: *", "maugis --preload-load 1"),
    ("--curve has no effect on theory crest: *", "crest --amplitude 1 --wavelength 9 --curve x.csv"),
    ("--preload-load is -1: expected a finite number >= 0*", "jkr --preload-load -1"),
    ("--load is nan: expected a finite number", "jkr --load nan"),
    ("--load is 0: expected --load-n, as the scene is in SI units",
     "jkr --from-physical --modulus-pa 2e9 --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 1e-7 --load 0"),
    ("standard output is asked for twice: *", "jkr --curve - --json")])
def test_messages(message, words):
    expect(2, "pulloff: " + message, "theory " + words)


def test_the_smooth_limit_of_a_preload():
    """Of a smooth sphere every preload gives the same pull-off."""
    for preload in ("--preload-load 0", "--preload-load 30", "--preload 0", "--preload 1e-3"):
        d = document("theory jkr --tabor 2.385 " + preload)
        assert d["after_preload_force"] == pytest.approx(1.5, rel=1e-13) and d["loading_jumps"] == 1
