"""Noise of measured profiles and uncertain inputs: what they do to the pull-off force, and what is said where that is no number."""

import math
import pathlib
import random

import pytest
from conftest import document, expect, load, rows_of

TABLE = "solve --coupling 0.05 --table-scale 3 --profile-file"
JUMP = "solve --tabor 3 --amplitude 1 --wavelength 20 --preload"  # another minimum is measured from the approach 2.616 on


def tip(r):
    return 30.0 - math.sqrt(900.0 - r * r) + 0.05 * (1.0 - math.cos(r))


def write(name, noise, rows=201, seed=7):
    draw = random.Random(seed)
    lines = [f"{0.1 * k!r},{tip(0.1 * k) + noise * draw.gauss(0, 1)!r}\n" for k in range(rows)]
    pathlib.Path(name).write_text("r,gap\n" + "".join(lines))
    return name


def uncertain(words):
    found = document(words)
    return found, found["uncertainty"], found["uncertainty"]["sources"]


@pytest.mark.parametrize("code, message, words", [
    (2, "--tabor is 1+-0: expected a number, or with +- a number and its uncertainty > 0", "solve --tabor 1+-0"),
    (2, "--tabor is 1+-x: expected a number, or*", "solve --tabor 1+-x"),
    (2, "--tabor is +-1: expected a number, or*", "solve --tabor +-1"),
    (2, "--nodes is 100+-1: expected a value without uncertainty", "solve --scheme ring --nodes 100+-1"),
    (2, "--tabor is 1+-2, and moved by twice its uncertainty it is refused: --tabor is -3: expected a finite number >= 0", "solve --tabor 1+-2"),
    (2, "--tabor is 1±0.1: expected a finite number >= 0; an uncertain number is written 0.05+-0.01, and only solve and cases take it; in place of follow, a case with a sweep does", "solve --tabor 1±0.1"),
    (2, "--tabor is 1+-0.1: expected *, and only solve and cases take it; *", "plot --tabor 1+-0.1"),
    (2, "--smooth is 0: expected a finite number > 0, or auto", "solve --smooth 0"),
    (2, "--smooth is no: expected a finite number > 0, or auto", "solve --smooth no"),
    (2, "--smooth is auto: expected it beside the file of a profile", "solve --smooth auto"),
    (2, "--smoothed is given without --smooth: expected both", "solve --smoothed tip.csv"),
])
def test_refused(code, message, words):
    expect(code, "pulloff: " + message, words)


def test_table_with_noise_is_told_to_smooth():
    expect(4, "pulloff: noisy.csv:*if the rows have noise, smooth with its standard deviation or auto", TABLE, write("noisy.csv", 0.1))
    expect(4, "pulloff: short.csv: 15 rows are too few for a smoothed profile: expected at least 16", TABLE, write("short.csv", 0.01, 15),
           "--smooth", "auto")


@pytest.mark.parametrize("coupling, noise", [(0.005, 0.01), (0.05, 0.03), (1, 0.003), (0, 0.03)])
def test_noise_of_a_profile(coupling, noise):
    """The deviation by the adjoint is the change of the force with the profile that belongs to it. The force of the table without
    noise is within three deviations."""
    name = write("tip.csv", noise)
    found, total, sources = uncertain(f"solve --coupling {coupling} --table-scale 3 --profile-file {name} --smooth auto --preload-load 1")
    [source] = sources
    assert source["source"] == "noise" and total["force"] == source["force"]
    assert abs(source["deviation"] / noise - 1) < 0.2
    assert abs((source["above"] - source["below"]) / (4 * source["force"]) - 1) < 1e-2
    assert found["pull_off"]["error_estimate"] is None or found["pull_off"]["error_estimate"] < 1e-3 * source["force"]
    true = document(f"solve --coupling {coupling} --table-scale 3 --profile-file {write('true.csv', 0)} --preload-load 1")
    assert "uncertainty" not in true
    assert abs(true["pull_off"]["force"] - found["pull_off"]["force"]) < 3 * source["force"]
    assert found["profile_table"]["smoothing"]["parameters"] < 40


@pytest.mark.once
def test_deviation_that_is_stated():
    """It takes the place of the estimate, and the command that repeats the solve has it."""
    name = write("tip.csv", 0.03)
    found, _, [source] = uncertain(f"{TABLE} {name} --smooth 0.03")
    assert source["deviation"] == pytest.approx(0.03, rel=1e-12) and found["input"]["smooth"] == 0.03
    assert abs(found["profile_table"]["smoothing"]["residual"] / 0.03 - 1) < 0.2
    printed = expect(0, "", f"{TABLE} {name} --smooth 0.03").out
    assert printed.count("\nuncertain noise of the profile: force +-") == 1 and "smooth 0.03 profile_file tip.csv" in printed


@pytest.mark.once
def test_noise_that_is_not_refused():
    """It moved the force without a word."""
    words = "solve --coupling 0.05 --profile-file"
    advice = "rows with noise are smoothed with its standard deviation, --smooth SIGMA or auto"
    assert advice in expect(0, "", words, write("noisy.csv", 0.02)).out
    assert advice not in expect(0, "", words, write("true.csv", 0)).out
    assert advice not in expect(0, "", words, write("noisy.csv", 0.02), "--smooth", "auto").out


def test_smoothed_table():
    """Gap and removed part together are the rows, relative to one on the axis; the table is one of the same profile."""
    name = write("tip.csv", 0.03)
    found = document(f"{TABLE} {name} --smooth auto --smoothed smoothed.csv")
    rows = [[{key: float(x) for key, x in row.items()} for row in rows_of(file)] for file in (name, "smoothed.csv")]
    axis = rows[0][0]["gap"] - rows[1][0]["removed"]
    for measured, smooth in zip(*rows, strict=True):
        assert measured["r"] == pytest.approx(smooth["r"], rel=1e-14)
        assert measured["gap"] - axis == pytest.approx(smooth["gap"] + smooth["removed"], abs=1e-12)
    rms = math.sqrt(sum(row["removed"] ** 2 for row in rows[1]) / len(rows[1]))
    assert rms == pytest.approx(found["profile_table"]["smoothing"]["removed_rms"], rel=1e-9)
    again = document(f"{TABLE} smoothed.csv")
    assert again["pull_off"]["force"] == pytest.approx(found["pull_off"]["force"], rel=1e-3)


CASE = """
name: noisy
title: A tip with noise
suites: [smoke]
scene: {{coupling: 0.05, amplitude: 0, outer_radius: inf, scheme: panel, tolerance: 1e-6, table_scale: 3, {}profile_file: {}}}
want: [pull_off]
"""


def test_smooth_in_a_case(data):
    """Case files have the key; there is no noise without it."""
    name = pathlib.Path(write("tip.csv", 0.03)).resolve()
    data.case("noisy", CASE.format("smooth: auto, ", name))
    expect(0, "*", "run noisy --output run")
    [point] = load("run/noisy/record.json")["points"]
    found, total, _ = uncertain(f"{TABLE} {name} --smooth auto --preload-load 65.95850597062925")
    assert point["input"]["smooth"] == "auto" and " --smooth auto " in point["command"]
    assert point["uncertainty"]["force"] == pytest.approx(total["force"], rel=1e-3)
    assert point["pull_off"]["force"] == pytest.approx(found["pull_off"]["force"], rel=1e-6)
    data.case("noisy", CASE.format("", name))
    expect(2, "*scene.profile_file is *: expected a CSV file *", "run noisy --output run")


@pytest.mark.once
def test_inputs_agree_with_their_sensitivities():
    """Differences of solves agree with the adjoint of the diagnostics; all together is the root of the sum of squares."""
    _, total, sources = uncertain("solve --tabor 2.385+-0.01 --amplitude 0.3+-0.002 --wavelength 17 --radius 93+-0.5")
    force = document("solve --tabor 2.385 --amplitude 0.3 --wavelength 17 --radius 93 --want diagnostics")
    by = force["diagnostics"]["sensitivity"]
    assert [s["source"] for s in sources] == ["tabor", "amplitude", "radius"]
    for source in sources:
        expected = force["pull_off"]["force"] * abs(by[source["source"]]) * source["deviation"] / source["value"]
        assert source["force"] == pytest.approx(expected, rel=2e-2)
    assert total["force"] == pytest.approx(math.hypot(*(s["force"] for s in sources)), rel=1e-12)


def test_si_units():
    """The force in N goes as the work of adhesion and the radius of a stiff sphere, and hardly with the modulus."""
    found = document("solve --from-physical --modulus-pa 2e12+-2e11 --work-j-per-m2 0.08+-0.008 --distance-m 3e-10 --radius-m 3e-8+-3e-9")
    si = found["physical"]["uncertainty"]
    force = found["physical"]["pull_off"]["force_n"]
    modulus, work, radius = si["sources"]
    assert work["force_n"] == pytest.approx(0.1 * force, rel=1e-2) and radius["force_n"] == pytest.approx(0.1 * force, rel=1e-2)
    assert work["value"] == 0.08 and work["deviation"] == 0.008 and modulus["force_n"] < 1e-2 * force
    assert si["force_n"] == pytest.approx(found["uncertainty"]["force"] * found["physical"]["units"]["force_n"], rel=1e-12)


def test_a_table_in_si_units_is_given_back():
    """The unit of the table and its noise were not in what was given: the tip was 1e9 times too large."""
    words = "solve --from-physical --tolerance 1e-3 --preload-load-n 1e-9"
    found = document(f"{words} --modulus-pa 5e9 --work-j-per-m2 0.08 --distance-m 3e-10 --table-scale 1e-9 --smooth 0.02 "
                     f"--profile-file {write('tip.csv', 0.02)}")
    given = found["physical"]["input"]
    assert (given["table_scale"], given["smooth"], given["profile_file"]) == (1e-9, 0.02, "tip.csv")
    again = " ".join(f"--{key.replace('_', '-')} {value}" for key, value in given.items())
    assert document(f"{words.replace(' --preload-load-n 1e-9', '')} {again}")["digest"] == found["digest"]


@pytest.mark.once
def test_preload_that_decides_between_two_minima():
    """The jump of the force is no standard uncertainty. Farther away the force does not depend on the preload at all."""
    found, total, [source] = uncertain(JUMP + " 2.6+-0.025")
    assert source["force"] is None and total["force"] is None
    assert source["below"] == pytest.approx(0, abs=1e-5) and source["above"] == pytest.approx(0.785524, abs=1e-4)
    printed = expect(0, "", JUMP + " 2.6+-0.025").out
    assert "uncertain preload 2.6+-0.025: no number, because the force is not linear there" in printed
    assert uncertain(JUMP + " 1.6+-0.05")[1]["force"] == pytest.approx(0, abs=1e-6)


def test_viscoelastic():
    """They were refused. The force through speed and time is that of both together: unloading at v with the time tau is at v tau."""
    scene = ("solve --from-physical --modulus-pa 2e9 --work-j-per-m2 {} --distance-m 5e-10 --radius-m 1e-8 --viscoelastic sls:0.3 "
             "--relaxation-time-s {} --unload-speed-m-per-s {} --preload-load-n 2e-9 --tolerance 1e-3")
    found = document(scene.format("0.05+-0.002", "0.1+-0.005", "5e-9+-2.5e-10"))
    sources = found["physical"]["uncertainty"]["sources"]
    assert [s["source"] for s in sources] == ["work_j_per_m2", "relaxation_time_s", "unload_speed_m_per_s"]
    assert sources[1]["force_n"] == pytest.approx(sources[2]["force_n"], rel=1e-6) and sources[1]["above_n"] > 0 > sources[1]["below_n"]
    for k, (low, high) in enumerate((("0.046", "0.054"), ("0.09", "0.11"))):
        forces = [document(scene.format(*(value if i == k else ("0.05", "0.1")[i] for i in range(2)), "5e-9"))["physical"]["pull_off"]["force_n"]
                  for value in (low, high)]
        assert sources[k]["force_n"] == pytest.approx((forces[1] - forces[0]) / 4, rel=1e-6)
    plain = document(scene.format("0.05", "0.1", "5e-9"))
    assert plain["physical"]["pull_off"] == found["physical"]["pull_off"]


def test_series_name_the_way():
    """follow has no uncertainties; its message says what has."""
    expect(2, "pulloff: --tabor is 1+-0.1: expected a finite number >= 0; an uncertain number is written 0.05+-0.01, and only solve and cases take "
           "it; in place of follow, a case with a sweep does", "follow --key amplitude --from 0.1 --to 0.3 --points 3 --wavelength 20 --tabor 1+-0.1")


def test_sample_beside_uncertain_numbers(data):
    """Scenes that are drawn have the uncertainties of the other numbers; the ranges that are drawn from have none."""
    text = """
name: drawn
title: Drawn tips
suites: [smoke]
scene: {tabor: 1+-0.05, radius: 100, outer_radius: inf, scheme: panel, tolerance: 1e-3, wavelength: 20}
sample: {seed: 3, count: 2, keys: [{key: amplitude, from: 0.01, to: 0.1}]}
want: [pull_off]
"""
    data.case("drawn", text)
    expect(0, "drawn: 2 points*", "run drawn --output run")
    for point in load("run/drawn/record.json")["points"]:
        words = f"solve --tabor 1+-0.05 --amplitude {point['input']['amplitude']!r} --wavelength 20 --tolerance 1e-3"
        assert point["uncertainty"]["force"] == pytest.approx(uncertain(words)[1]["force"], rel=1e-6)
    data.case("drawn", text.replace("to: 0.1}", "to: 0.1+-0.01}"))
    expect(2, "*sample.keys?1?.to is 0.1+-0.01: expected a number without uncertainty, as scenes are drawn between from and to; other numbers *",
           "run drawn --output run")


def test_nothing_else_changes():
    """The results without uncertainties are those of the same input without +-, to the last bit."""
    plain, with_uncertainty = document("solve --tabor 1.385"), document("solve --tabor 1.385+-0.1")
    for found in (plain, with_uncertainty):
        for key in ("digest", "work", "uncertainty"):
            found.pop(key, None)
    assert plain == with_uncertainty


def test_deviation_in_another_unit():
    """A deviation that is not that of the rows would be stated as their noise."""
    name = write("tip.csv", 0.03)
    for wrong in "0.00003", "30":
        expect(4, f"pulloff: {name}: smooth is *, but the rows are off the smoothing spline by 0.0*, both in the unit of the file: "
               "expected a deviation within a factor of 3 of that, or auto", f"{TABLE} {name} --smooth {wrong}")


def test_rounding_of_a_scheme_without_errors_is_linear():
    """The load of rings does not depend on the radius, in its own unit."""
    [by] = document("solve --tabor 1 --radius 100+-1 --scheme ring --nodes 60")["uncertainty"]["sources"]
    assert by["force"] is not None and abs(by["force"]) < 1e-12


def test_noise_of_many_waves(tmp_path):
    """16 knots, of which a parabola uses few, do not resolve twenty waves: these were taken for noise."""
    of, rows = random.Random(4), []
    for k in range(401):
        r = 0.1 * k
        rows.append(f"{r:.4f},{r * r / 100 + 0.5 * (1 - math.cos(math.pi * r)) + of.gauss(0, 0.01):.6f}")
    (tmp_path / "waves.csv").write_text("r,gap\n" + "\n".join(rows) + "\n")
    out = expect(0, "", f"solve --coupling 0.01 --profile-file {tmp_path / 'waves.csv'} --smooth auto --tolerance 1e-4").out
    assert float(out.split("smoothed noise ")[1].split()[0]) == pytest.approx(0.01, rel=0.15)


TIPS = """
name: tips
title: Tips of uncertain size and adhesion
suites: [smoke]
scene:
  physical: {{modulus_pa: 2e9, work_j_per_m2: {work}, distance_m: 3e-10}}
  scheme: panel
sweep:
  - {{{sweep}}}
want: [pull_off]
{more}
"""
RADII = "key: radius_m, values: [1e-8+-1e-9, 3e-8]"


def tips(data, work="0.05+-0.002", sweep=RADII, more=""):
    data.case("tips", TIPS.format(work=work, sweep=sweep, more=more))


@pytest.mark.once
def test_case(data):
    """Each point of a case has the standard uncertainty of the same command line, in the record and in the summary. A result
    that is kept is not that of another uncertainty."""
    for work, message in (("0.05+-0.002", "tips: 2 points, 0 checks: within"), ("0.05+-0.002", "tips: *(kept)"), ("0.05+-0.004", "tips: *within")):
        tips(data, work)
        expect(0, message, "run tips --output run --summary summary.csv")
        points, rows = load("run/tips/record.json")["points"], rows_of("summary.csv")
        for point, row, radius in zip(points, rows, ("1e-8+-1e-9", "3e-8"), strict=True):
            words = f"solve --from-physical --modulus-pa 2e9 --work-j-per-m2 {work} --distance-m 3e-10 --radius-m {radius}"
            found, expected = point["physical"]["uncertainty"], document(words)["physical"]["uncertainty"]
            assert [s["source"] for s in found["sources"]] == [s["source"] for s in expected["sources"]]
            assert all(s["force_n"] > 0 for s in expected["sources"])
            for mine, other in zip([found, *found["sources"]], [expected, *expected["sources"]]):
                assert mine["force_n"] == pytest.approx(other["force_n"], rel=1e-6)
            assert float(row["force_uncertainty_nN"]) == pytest.approx(1e9 * expected["force_n"], rel=1e-6)
            assert point["sweep"] == {"radius_m": float(radius.partition("+")[0])} and "+-" not in point["label"]
            assert point["command"].startswith("pulloff verify tips --points ")
    tips(data, "0.05", RADII.replace("+-1e-9", ""))
    expect(0, "*", "run tips --output run --summary summary.csv")
    assert "force_uncertainty_nN" not in rows_of("summary.csv")[0] and "uncertainty" not in load("run/tips/record.json")["points"][0]


def test_case_of_dimensionless_numbers(data):
    """Of a group, a preload and settings of a table, whose semicolons are commas."""
    data.case("tips", """
name: tips
title: Waves of uncertain height
suites: [smoke]
scene: {tabor: 1+-0.05, radius: 100, outer_radius: inf, wavelength: 20, scheme: panel, preload: 1+-0.1}
sweep:
  - {key: amplitude_ratio, values: [0.01+-0.002, 0.02]}
want: [pull_off]
""")
    expect(0, "tips: 2 points*", "run tips --output run")
    for point, ratio in zip(load("run/tips/record.json")["points"], ("0.01+-0.002", "0.02"), strict=True):
        amplitude = "0.2+-0.04" if "+-" in ratio else "0.4"
        _, total, sources = uncertain(f"solve --tabor 1+-0.05 --amplitude {amplitude} --wavelength 20 --preload 1+-0.1")
        found = {s["source"]: s["force"] for s in point["uncertainty"]["sources"]}
        assert found.pop("amplitude_ratio", None) == pytest.approx(next((s["force"] for s in sources if s["source"] == "amplitude"), None))
        assert found == pytest.approx({s["source"]: s["force"] for s in sources if s["source"] != "amplitude"})
        assert point["uncertainty"]["force"] == pytest.approx(total["force"])
    pathlib.Path("own").mkdir()
    pathlib.Path("own/bodies.csv").write_text("young_pa,radius_m\n160e9;2e9+-2e8,1e-8+-1e-9\n")
    pathlib.Path("own/bodies.yaml").write_text(TIPS.format(work="0.05", sweep="table: bodies.csv", more="").replace("tips", "bodies")
                                               .replace("modulus_pa: 2e9", 'poisson: "0.2,0.4"'))
    expect(0, "bodies: 1 point*", "run own/bodies.yaml --output run")
    [point] = load("run/bodies/record.json")["points"]
    words = "--young-pa 160e9,2e9+-2e8 --poisson 0.2,0.4 --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 1e-8+-1e-9"
    _, total, sources = uncertain("solve --from-physical " + words)
    assert [s["source"] for s in point["uncertainty"]["sources"]] == [s["source"] for s in sources]
    assert len(sources) == 2
    assert point["uncertainty"]["force"] == pytest.approx(total["force"], rel=1e-6)


def test_check_of_the_uncertainty(data):
    total = uncertain("solve --tabor 1+-0.05")[1]["force"]
    data.table("reference/u.csv", "tabor,standard_uncertainty", f"1,{total!r}")
    data.case("one", """
name: one
title: One sphere
suites: [smoke]
scene: {tabor: TABOR, radius: 100, outer_radius: inf, scheme: panel}
want: [pull_off]
checks:
  - {quantity: pull_off_uncertainty, reference: reference/u.csv, tolerance: 1e-8, kind: abs, because: the same solves}
""".replace("TABOR", "1+-0.05"))
    expect(0, "one: 1 point, 1 check: within", "run one --output run")
    path = data.folder / "cases/one.yaml"
    for uncertainty, verdict in (("+-0.06", "outside"), ("", "no_result")):
        path.write_text(path.read_text().replace("1+-0.05", "1" + uncertainty).replace("1+-0.06", "1" + uncertainty))
        assert verdict in expect(1, "*", "verify --verbose one --output run").out


@pytest.mark.parametrize("message, changed", [
    ("scene.physical.work_j_per_m2 is 1+-x: expected a number, or with +- a number and its uncertainty > 0", {"work": "1+-x"}),
    ("scene (radius_m=1e-8): work_j_per_m2 is 0.05+-0.03, and moved by twice its uncertainty it is refused: *", {"work": "0.05+-0.03"}),
    ("sweep[1].values[2]: radius_m is 3e-8+-0: expected a number, or*", {"sweep": RADII.replace("3e-8", "3e-8+-0")}),
    ("sweep[1].together[1].nodes is 9+-1: expected a value without uncertainty", {"sweep": "together: [{radius_m: 1e-8, nodes: 9+-1}]"}),
    ("follow is radius_m: expected it to be left out, as scenes with uncertain numbers (+-) are traced", {"more": "follow: radius_m"}),
    ("*.values[1] is 1+-0.1: expected a finite number >= 0", {"more": "checks: [{quantity: pull_off_force, reference: bradley, tolerance: 1, "
     "kind: abs, because: x, when: [{key: tabor, values: [1+-0.1]}]}]"}),
])
def test_refused_in_a_case(data, message, changed):
    tips(data, **changed)
    expect(2, "pulloff: *tips.yaml:*: " + message, "run tips --output run")
