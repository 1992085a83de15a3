"""--from-physical: a scene in SI units is converted to a dimensionless scene and solved, and its results are printed in newton
and metre, too. Both kinds of options cannot be mixed, and missing options are named."""

import math
import pathlib
import re

import pytest
from conftest import document, expect, run

E, W, EPS, R = 1.3385e9, 0.0537, 3.1e-10, 2.7e-8
BODY = f" --from-physical --modulus-pa {E:g} --work-j-per-m2 {W} --distance-m {EPS} --radius-m {R}"
TIP = "--from-physical --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 1e-7"


def near(a, b, tolerance=4e-15):
    return (a == b == 0) or abs(a / b - 1) < tolerance


def test_si_and_dimensionless_results_agree():
    d = document("solve --amplitude-m 1.3e-10 --wavelength-m 6.3e-9 --outer-radius-m 3.3e-8 --scheme triangle --nodes 201 "
                 "--approach-start-m -1.7e-9 --approach-end-m 1.1e-10 --profile-approach-m -2.3e-10 --want curve,profile" + BODY)
    i, p = d["input"], d["physical"]
    assert near(i["tabor"], (R * W**2 / (E**2 * EPS**3)) ** (1 / 3))
    for key, metres in (("radius", R), ("amplitude", 1.3e-10), ("wavelength", 6.3e-9), ("outer_radius", 3.3e-8),
                        ("approach_start", -1.7e-9), ("approach_end", 1.1e-10)):
        assert near(i[key], metres / EPS), key
        assert p["input"][key + "_m"] == metres, key
    assert (p["input"]["modulus_pa"], p["input"]["work_j_per_m2"], p["input"]["distance_m"]) == (E, W, EPS)
    force, traction = math.pi * W * R, W / (i["tabor"] * EPS)
    assert near(p["units"]["force_n"], force) and p["units"]["length_m"] == EPS
    assert near(p["units"]["traction_pa"], traction)
    assert near(p["pull_off"]["force_n"], d["pull_off"]["force"] * force)
    assert near(p["pull_off"]["approach_m"], d["pull_off"]["approach"] * EPS)
    assert near(p["pull_off"]["contact_radius_m"], d["pull_off"]["contact_radius"] * EPS)
    for key in "folds", "extrema", "curve":
        assert len(p[key]) == len(d[key]) > 0, key
        for a, b in zip(p[key], d[key]):
            assert near(a["load_n"], b["load"] * force) and near(a["approach_m"], b["approach"] * EPS)
            assert a.get("error_estimate_m") == b.get("error_estimate") == None  # noqa: E711
            assert near(a["contact_radius_m"], b["contact_radius"] * EPS) and a.get("kind") == b.get("kind")
    assert len(p["profile"]) == len(d["profile"]) > 100
    for a, b in zip(p["profile"], d["profile"]):
        assert near(a["gap_m"], (1 + b["gap"]) * EPS) and near(a["traction_pa"], b["traction"] * traction)
        assert near(a["radius_m"], b["radius"] * EPS)
    assert abs(p["profile_approach_m"] + 2.3e-10) < 1e-19

    # the same dimensionless scene, equal to the last bit
    flags = [word for key in ("tabor", "amplitude", "wavelength", "radius", "outer_radius", "scheme", "nodes", "approach_start",
                              "approach_end") for word in ("--" + key.replace("_", "-"), i[key])]
    same = document("solve --want curve,profile --profile-approach", repr(-2.3e-10 / EPS), *flags)
    assert "physical" not in same
    for key in set(same) - {"work"}:
        assert same[key] == d[key], key


def test_errors_of_panels_in_si_units():
    found = document("solve --scheme panel" + BODY)
    a, b, force = found["physical"]["pull_off"], found["pull_off"], math.pi * W * R
    assert near(a["error_estimate_n"], b["error_estimate"] * force)
    assert near(a["approach_error_estimate_m"], b["approach_error_estimate"] * EPS)
    for a, b in zip(found["physical"]["folds"], found["folds"]):
        assert near(a["error_estimate_m"], b["error_estimate"] * EPS)
        assert near(a["load_error_estimate_n"], b["load_error_estimate"] * force)


def test_the_printed_result():
    printed = expect(0, "", "solve --scheme triangle --nodes 101" + BODY)
    d = document("solve --scheme triangle --nodes 101" + BODY)
    found = d["physical"]["pull_off"]
    assert (f"pull-off force {found['force_n'] * 1e9:.10g} nN at approach {found['approach_m'] * 1e9:.10g} nm, contact radius "
            f"{found['contact_radius_m'] * 1e9:.8g} nm") in printed.out.splitlines()
    assert printed.count("^point +approach/nm +load/nN +contact radius/nm$")
    assert "physical modulus_pa 1.3385e+09 work_j_per_m2 0.0537 distance_m 3.1e-10 radius_m 2.7e-08" in printed.out.splitlines()
    printed = expect(0, "", "solve --preload-m 4e-10 --scheme triangle --nodes 101" + BODY)
    assert printed.count("^physical .* preload_m 4e-10$")
    assert printed.count("^preload  loading to approach [0-9.e-]+ nm, load [0-9.e-]+ nN, or more gives this pull-off$")


def test_numbers_that_have_a_rounding_error_are_printed_as_they_were_given():
    """3e-8/3e-10 is 99.99999999999999 in doubles, and the scene keeps that. A number that is no other with 15 digits but for
    rounding stays, and so does every number of a dimensionless scene."""
    tip = " --from-physical --modulus-pa 2e9 --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 3e-8"
    line = expect(0, "", "solve --scheme ring --nodes 51 --amplitude-m 4e-10 --wavelength-m 6e-9" + tip).out.splitlines()[0]
    assert " radius 100 " in line and " wavelength 20 " in line and " amplitude 1.3333333333333335 " in line
    assert document("solve --scheme ring --nodes 51" + tip)["input"]["radius"] == 3e-8 / 3e-10 != 100
    assert " radius 99.99999999999999 " in expect(0, "", "solve --scheme ring --nodes 51 --radius 99.99999999999999").out


def columns(words):
    """The columns of a table on standard output, and what the name of each says after its last underline."""
    lines = [line for line in run(words).out.splitlines() if not line.startswith("#")]
    return {name: [float(x) if x[-1].isdigit() else x for x in column]
            for name, *column in zip(*(line.split(",") for line in lines))}


def test_tables_in_si_units():
    """A table of a scene in SI units has the numbers of the dimensionless one in the units that its names state."""
    tip = " --from-physical --modulus-pa 5e9 --work-j-per-m2 0.08 --distance-m 3e-10 --radius-m 3e-8"
    i = document("solve --tolerance 1e-4" + tip)["input"]
    same = f" --tabor {i['tabor']!r} --radius {i['radius']!r}"
    force, length = math.pi * 0.08 * 3e-8 * 1e9, 0.3
    size = {"nm": length, "nN": force, "aJ": force * length, "MPa": 0.08 / 3e-10 / i["tabor"] / 1e6}
    for option in "curve", "profile-csv", "staircase":
        words = f"solve --tolerance 1e-4 --{option} -"
        plain, si = columns(words + same), columns(words + tip)
        assert len(si) > 2 and not {name for name in si if "position" in name or "rate" in name}
        for name, values in si.items():
            key, _, unit = name.rpartition("_")
            key, factor = (key, size[unit]) if unit in size else (name, 1)
            for a, b in zip(values, plain[key], strict=True):
                b = 1 + b if key == "gap" else b
                assert a == b or near(a, b * factor, 4e-14), name


def test_the_guide_reads_such_a_table():
    numpy = pytest.importorskip("numpy")
    guide = (pathlib.Path(__file__).parents[2] / "doc" / "guide.md").read_text(encoding="utf-8")
    [given] = re.findall(r'numpy\.genfromtxt\("si\.csv", (.*)\)', guide)
    expect(0, "", f"solve --tolerance 1e-4 {TIP} --modulus-pa 5e9 --curve si.csv")
    table = numpy.genfromtxt("si.csv", **eval(f"dict({given})"))
    assert len(table["approach_nm"]) == len(table["load_nN"]) > 10 and numpy.isfinite(table["load_nN"]).all()


def test_printed_loops_and_staircases_in_si_units():
    tip = " --from-physical --modulus-pa 5e9 --work-j-per-m2 0.08 --distance-m 3e-10 --radius-m 3e-8 --amplitude-m 4e-10 --wavelength-m 6e-9"
    words = "solve --tolerance 1e-4 --want hysteresis,preload --preload-load-n 2e-9 --stiffness-n-per-m 2" + tip
    printed, d = expect(0, "", words), document(words)
    force, length = math.pi * 0.08 * 3e-8 * 1e9, 0.3
    loop = d["hysteresis"]["spring"]
    assert printed.count(rf"^spring of stiffness 2 N/m: loading reversed at approach {loop['preload']['approach'] * length:.6g} nm, "
                         rf"load 2 nN; measured pull-off force {loop['pull_off']['force'] * force:.8g} nN at approach .* nm; "
                         rf"energy lost {loop['energy_lost'] * force * length:.6g} aJ, error ")
    jump = loop["jumps"][0]
    assert printed.count(rf"^1 +loading .* {jump['before']['load'] * force:.8g} +{jump['after']['load'] * force:.8g} ")
    assert printed.count("^load control: pull-off force against preload, in nm, nN and aJ$") == 1
    step = d["staircase"]["displacement_control"]["steps"][0]
    assert printed.count(f" {step['force'] * force:.10g} +[0-9.e-]+ +{step['approach'] * length:.10g} ")


def test_the_prefix_of_a_profile_without_a_radius():
    """Its unit of load, pi w epsilon = 0.05 nN, says nothing about its loads, which are those of the sphere that it is."""
    tip = "solve --from-physical --modulus-pa 2e9 --work-j-per-m2 0.05 --distance-m 3e-10 --tolerance 1e-4"
    sphere = expect(0, "", tip + " --radius-m 3e-8")
    same = expect(0, "", tip + " --profile power:1.6666666666666666e7,2")
    for printed in sphere, same:
        assert printed.count(r"^pull-off force 7\.962[0-9]* nN at approach -0\.2339[0-9]* nm, ")


def test_a_smooth_sphere_needs_no_wavelength():
    assert document("solve --amplitude-m 0" + BODY)["digest"] == document("solve" + BODY)["digest"]


def test_the_rigid_sphere_has_the_force_of_bradley():
    d = document("solve --modulus-pa inf " + TIP)
    assert d["rigid"] and abs(d["physical"]["pull_off"]["force_n"] / (2 * math.pi * 0.05e-7) - 1) < 1e-9
    assert d["physical"]["input"]["modulus_pa"] == "inf" and d["physical"]["units"]["traction_pa"] is None


@pytest.mark.parametrize("key, value, words", [  # by hand: 3/2 pi w R; a^3 = 9 pi w R^2/(8 E*)
    ("pull_off_force_n", 6.832492782659762e-09, "jkr" + BODY),
    ("pull_off_contact_radius_m", 4.693123085913775e-09, "jkr" + BODY),
    ("load_n", -3.1415926535897932e-08, "bradley --approach-m 0 " + TIP),
    ("effective_work_j_per_m2", 0.0537, "kesari-lew --amplitude-m 0" + BODY),
    ("peak_tension_pa", 171066746.4265558, "lennard-jones " + TIP),
    ("peak_tension_pa", 171066746.4265558, "lennard-jones --from-physical --work-j-per-m2 0.05 --distance-m 3e-10"),
    ("pull_off_force_n", 1.1640478568314679e-08, "rigid --alpha 0.25 --amplitude-m 3e-10 " + TIP)])
def test_closed_forms(key, value, words):
    assert near(document("theory " + words)["physical"][key], value, 1e-12)


def test_the_printed_closed_form_has_units():
    assert expect(0, "", "theory guduru --amplitude-m 1e-10 --wavelength-m 5e-9" + BODY).count(r"^pull_off_force +[0-9.]* nN$")


@pytest.mark.parametrize("verb", ["solve", "theory jkr"])
@pytest.mark.parametrize("message, words", [
    ("--tabor is 1: expected it to be left out, as it follows from the values in SI units", "--tabor 1" + BODY),
    ("--radius-m is 2.7e-08: expected only one of --radius and --radius-m", "--radius 3" + BODY),
    ("--amplitude is 3: expected --amplitude-m, as the scene is in SI units", "--amplitude 3" + BODY),
    ("--radius-m is 3: expected it with --from-physical, as it is in SI units", "--radius-m 3"),
    ("--modulus-pa is 3: expected it with --from-physical, *", "--modulus-pa 3"),
    ("--modulus-pa is missing: expected a finite number > 0, or inf; a scene in SI units has --modulus-pa, --work-j-per-m2, "
     "--distance-m and, of a sphere, --radius-m", "--from-physical"),
    ("--work-j-per-m2 is missing: expected a finite number > 0; *", "--from-physical --modulus-pa 1e9 --distance-m 1e-9"),
    ("--distance-m is 0: expected a finite number > 0", "--distance-m 0 --from-physical --modulus-pa 1 --work-j-per-m2 1"),
    ("--modulus-pa is -1: expected a finite number > 0, or inf", "--from-physical --modulus-pa -1"),
    ("the Tabor parameter is inf: expected a number within the range of doubles; *",
     "--from-physical --modulus-pa 1e-300 --work-j-per-m2 1e300 --distance-m 1e-300 --radius-m 1e300")])
def test_mixed_and_incomplete_options(verb, message, words):
    expect(2, "pulloff: " + message, f"{verb} {words}")


@pytest.mark.parametrize("message, words", [
    ("--wavelength-m is missing: expected it beside --amplitude-m", "solve --amplitude-m 1e-9" + BODY),
    ("--approach-end is 0: expected --approach-end-m, as the scene is in SI units", "solve --approach-end 0" + BODY),
    ("--profile-approach is 0: expected --profile-approach-m, *", "solve --profile-approach 0" + BODY),
    ("--modulus-pa is inf: expected a finite number > 0", "theory jkr --modulus-pa inf " + TIP),
    ("--approach-m is 3e-10: expected less than --distance-m, 3e-10", "theory bradley --approach-m 3e-10 " + TIP),
    ("theory guduru needs --amplitude-m and --wavelength-m", "theory guduru" + BODY)])
def test_options_of_one_verb(message, words):
    expect(2, "pulloff: " + message, words)


# The line "inputs": what 1 % more of an input changes, against solves with a changed input.

def with_options(options, more):
    return "solve " + " ".join(f"--{name} {value!r}".replace("'", "") for name, value in options.items()) + " " + more


def stated(options, more=""):
    """The changes in percent of each line `inputs`, by input."""
    lines = [line for line in expect(0, "", with_options(options, more)).out.splitlines() if line.startswith("inputs   1 % more ")]
    return [{name: float(value) for name, value in re.findall(r"([a-z]+) (?:changes the force by )?(-?[\d.e-]+) %", line[18:])}
            for line in lines]


def measured(options, name, force, more):
    """The change in percent, from 0.5 % less to 0.5 % more."""
    less, greater = (math.log(force(document(with_options({**options, name: options[name] * math.exp(step)}, more))))
                     for step in (-0.005, 0.005))
    return 100 * (greater - less)


def load(d):
    return d["pull_off"]["force"]


def newtons(d):
    return d["physical"]["pull_off"]["force_n"]


@pytest.mark.parametrize("options, line, names, force, more", [
    ({"coupling": 0.05, "profile": "cone:0.3"}, 0, {"coupling": "coupling"}, load, ""),
    ({"modulus-pa": 2e9, "work-j-per-m2": 0.05, "distance-m": 3e-10, "radius-m": 3e-8, "amplitude-m": 2e-10, "wavelength-m": 4e-9}, 1,
     {"modulus": "modulus-pa", "work": "work-j-per-m2", "amplitude": "amplitude-m", "wavelength": "wavelength-m", "radius": "radius-m"},
     newtons, "--from-physical")])
def test_the_changes_that_1_percent_of_each_input_makes(options, line, names, force, more):
    changes = stated(options, more)[line]
    assert set(changes) == set(names)
    for shown, name in names.items():
        assert abs(changes[shown] - measured(options, name, force, more)) < 2e-3, shown


def test_scenes_without_such_changes():
    assert stated({"tabor": 0.0}) == stated({"tabor": 1.0, "scheme": "ring"}) == []
    assert abs(stated({"tabor": 1.0})[0]["radius"]) < 1e-4, "of a smooth sphere the radius is only a unit"


def test_printed_units_follow_the_numbers():
    """The force was printed as 24747.27659 fN or 151255.502 pN: the prefix was that of the scene, not of the number."""
    flat = "solve --from-physical --modulus-pa 1e9 --work-j-per-m2 0.05 --distance-m 3e-10 --profile truncated:1e-6,1e-5"
    for words, unit in ((flat, "[munp]?N|µN"), ("solve --from-physical --modulus-pa inf --work-j-per-m2 1e-5 --distance-m 3e-10 "
                                                "--profile cone:0.05", "[munpf]N|µN")):
        printed = expect(0, "", words).out
        force = re.search(rf"^pull-off force ([0-9.]+) ({unit}) at", printed, flags=re.M).group(1)
        assert 0.1 <= float(force) < 1000, printed


def test_an_approach_of_rounding_has_the_unit_of_the_scene():
    """That of a rigid sphere was printed as 0.006245004514 ym, with an error of 3.0e+05 ym."""
    rigid = "--from-physical --modulus-pa inf --distance-m 3e-10 --radius-m 1e-7"
    for words in (f"solve {rigid} --work-j-per-m2 0.05 --want preload",
                  f"follow {rigid} --key work-j-per-m2 --from 0.05 --to 0.06 --points 3"):
        printed = expect(0, "", words).out
        assert re.search("approach/nm|lengths in nm,", printed) and not re.search(r"[ /]ym\b", printed), printed


@pytest.mark.parametrize("option, value, words", [
    ("distance-m", "0.3", "0.3 m, which looks like another unit: usual are 1e-11 to 1e-07 m"),
    ("distance-m", "1e-12", "1e-12 m, which looks like another unit: usual are 1e-11 to 1e-07 m"),
    ("radius-m", "300", "300 m, which looks like another unit: usual are 1e-10 to 100 m"),
    ("modulus-pa", "5e15", "5e+15 Pa, which looks like another unit: usual are 1 to 2.5e+12 Pa"),
    ("work-j-per-m2", "50", "50 J/m^2, which looks like another unit: usual are 1e-08 to 20 J/m^2")])
def test_slips_of_units_are_remarked(option, value, words):
    scene = {"modulus-pa": "2e9", "work-j-per-m2": "0.05", "distance-m": "3e-10", "radius-m": "1e-7"}
    command = "theory jkr --from-physical " + " ".join(f"--{key} {text}" for key, text in (scene | {option: value}).items())
    expect(0, f"pulloff: warning: --{option} is {words}", command)
    expect(0, "", "theory jkr --from-physical " + " ".join(f"--{key} {text}" for key, text in scene.items()))


TWO = "--from-physical --work-j-per-m2 0.0537 --distance-m 3.1e-10 --tolerance 1e-4"


def contact(*bodies):
    """E* of bodies with Young's modulus and Poisson's ratio."""
    return 1 / sum((1 - nu**2) / e for e, nu in bodies)


@pytest.mark.parametrize("bodies, radii", [([(160e9, 0.22), (2.385e9, 0.41)], [2.7e-8, 4.1e-8]), ([(2.385e9, 0.41)], [2.7e-8]),
                                           ([(2.385e9, 0.5), (7.1e9, -0.3)], [2.7e-8, math.inf])])
def test_two_bodies_are_their_contact_modulus_and_radius(bodies, radii):
    words = (f"--young-pa {','.join(repr(e) for e, _ in bodies)} --poisson {','.join(repr(nu) for _, nu in bodies)} "
             f"--radius-m {','.join(repr(r) for r in radii if r < math.inf)}")
    modulus, radius = contact(*bodies), 1 / sum(1 / r for r in radii)
    two = document(f"solve {TWO} {words}")
    one = document(f"solve {TWO} --modulus-pa {modulus!r} --radius-m {radius!r}")
    assert near(two["physical"]["bodies"]["modulus_pa"], modulus) and near(two["physical"]["bodies"]["radius_m"], radius)
    assert "bodies" not in one["physical"]
    for key in "tabor", "radius":
        assert near(two["input"][key], one["input"][key]), key
    assert near(two["physical"]["pull_off"]["force_n"], one["physical"]["pull_off"]["force_n"], 1e-9)
    line = next(line for line in expect(0, "", f"solve {TWO} {words}").out.splitlines() if line.startswith("bodies   contact modulus E*"))
    said = [float(word) for word in re.findall(r"[-0-9.e+]+(?= Pa| m)", line)]
    assert near(said[0], modulus, 1e-9) and near(said[1], radius, 1e-9)
    # the other verbs take them, too
    assert near(document(f"theory jkr {TWO.replace('--tolerance 1e-4', '')} {words}")["physical"]["bodies"]["modulus_pa"], modulus)


def test_uncertain_bodies():
    """Each number of a pair is a source of its own: d ln F by d ln E of one body is that of E*, times its part of the compliance."""
    bodies = [(9e9, 0.22), (2e9, 0.4)]
    scene = f"solve {TWO} --radius-m 2e-8,5e-8"
    found = document(f"{scene} --young-pa 9e9+-1e8,2e9+-3e7 --poisson 0.22,0.4+-0.01")["uncertainty"]["sources"]
    assert [s["source"] for s in found] == ["young_pa of body 1", "young_pa of body 2", "poisson of body 2"]
    assert [(s["value"], s["deviation"]) for s in found] == [(9e9, 1e8), (2e9, 3e7), (0.4, 0.01)]
    modulus = contact(*bodies)
    whole = document(f"{scene} --modulus-pa {modulus!r}+-{modulus / 100!r}")["uncertainty"]["sources"][0]["force"]
    for source, (e, nu), change in ((found[0], bodies[0], 1e8 / 9e9), (found[1], bodies[1], 3e7 / 2e9)):
        part = (1 - nu**2) / e * modulus
        assert source["force"] == pytest.approx(whole * 100 * change * part, rel=0.05)
    [radius] = document(f"solve {TWO} --modulus-pa 2e9 --radius-m 2e-8+-1e-10,5e-8")["uncertainty"]["sources"]
    assert radius["source"] == "radius_m of body 1" and radius["force"] > 0


@pytest.mark.parametrize("words, message", [
    ("--young-pa 1e9", "--poisson is missing: expected a number from -1 to 0.5, or two with a comma between, beside --young-pa"),
    ("--poisson 0.3", "--young-pa is missing: expected *, beside --poisson"),
    ("--young-pa 1e9,2e9 --poisson 0.3", "--poisson is 0.3: expected one number for each of --young-pa"),
    ("--young-pa 1e9 --poisson 0.51", "--poisson is 0.51: expected a number from -1 to 0.5, or two with a comma between"),
    ("--young-pa 1e9,2e9,3e9 --poisson 0.3,0.3", "--young-pa is 1e9,2e9,3e9: expected a number > 0 or inf, or two with a comma between"),
    ("--young-pa 1e9 --poisson 0.3 --modulus-pa 1e9", "--young-pa is 1e9: expected it to be left out beside --modulus-pa, the contact modulus"),
    ("--young-pa 1e9+-,2e9 --poisson 0.3,0.3", "--young-pa is 1e9+-,2e9: expected a number, or with +- a number and its uncertainty > 0")])
def test_wrong_bodies(words, message):
    expect(2, f"pulloff: {message}", f"solve {TWO} --radius-m 2e-8 {words}")
    expect(2, "pulloff: --radius-m is 2e-8,-1: expected a finite number > 0, or two with a comma between",
           f"solve {TWO} --modulus-pa 1e9 --radius-m 2e-8,-1")


ENERGIES = "solve --from-physical --modulus-pa 2e9 --distance-m 3e-10 --radius-m 2e-8 --tolerance 1e-4"


@pytest.mark.parametrize("energies", [(0.025, 0.04, 0.015), (0.025, 0.04), (0.03, 0)])
def test_work_of_adhesion_from_surface_energies(energies):
    """Dupre: w = gamma1 + gamma2 - gamma12. The results are those of this w, and the line of the bodies states it."""
    text = ",".join(map(repr, energies))
    work = energies[0] + energies[1] - sum(energies[2:])
    one, two = document(f"{ENERGIES} --work-j-per-m2 {work!r}"), document(f"{ENERGIES} --surface-energies-j-per-m2 {text}")
    assert one["digest"] == two["digest"] and one["physical"]["pull_off"] == two["physical"]["pull_off"]
    assert two["physical"]["bodies"] == {"modulus_pa": None, "radius_m": 2e-8, "work_j_per_m2": work}
    assert two["physical"]["input"]["surface_energies_j_per_m2"] == text
    printed = expect(0, "", f"{ENERGIES} --surface-energies-j-per-m2 {text}").out
    assert f"\nbodies   radius R 2e-08 m, work of adhesion w {work:.10g} J/m^2\n" in printed
    scene = ENERGIES.partition("solve ")[2].partition(" --tolerance")[0]
    assert f", work of adhesion w {work:.10g} J/m^2\n" in expect(0, "", f"theory jkr {scene} --surface-energies-j-per-m2 {text}").out
    series = f"follow {scene.replace('--radius-m 2e-8', '')} --key radius-m --from 1e-8 --to 2e-8 --points 2"
    assert document(f"{series} --surface-energies-j-per-m2 {text}")["digest"] == document(f"{series} --work-j-per-m2 {work!r}")["digest"]


def test_uncertain_surface_energies():
    """Each is a source of its own: d F/d gamma is d F/d w, with the sign of its term."""
    found = document(f"{ENERGIES} --surface-energies-j-per-m2 0.025+-0.001,0.04+-0.002,0.015+-0.003")["uncertainty"]["sources"]
    whole = document(f"{ENERGIES} --work-j-per-m2 0.05+-0.001")["physical"]["uncertainty"]["sources"][0]
    names = [f"surface_energies_j_per_m2 of {part}" for part in ("body 1", "body 2", "the interface")]
    assert [(s["source"], s["value"], s["deviation"]) for s in found] == list(zip(names, (0.025, 0.04, 0.015), (0.001, 0.002, 0.003)))
    si = document(f"{ENERGIES} --surface-energies-j-per-m2 0.025+-0.001,0.04+-0.002,0.015+-0.003")["physical"]["uncertainty"]["sources"]
    for source, times in zip(si, (1, 2, 3)):
        assert source["force_n"] == pytest.approx(times * whole["force_n"], rel=1e-2)
    assert si[0]["above_n"] > 0 > si[2]["above_n"]


@pytest.mark.parametrize("words, message", [
    ("0.03,0.03 --work-j-per-m2 0.06", "0.03,0.03: expected it to be left out beside --work-j-per-m2, the work of adhesion"),
    ("0.03", "0.03: expected G1,G2 or G1,G2,G12, numbers >= 0, with G1 + G2 - G12 > 0"),
    ("0.03,0.02,0.05", "0.03,0.02,0.05: expected G1,G2 or G1,G2,G12, numbers >= 0, with G1 + G2 - G12 > 0"),
    ("0.03,-0.02", "0.03,-0.02: expected *"), ("0.03,inf", "0.03,inf: expected *"), ("0.03,0.02,0.01,0.01", "*: expected *"),
    ("0.03+-0.02,0", "0.03,0+-0.02, and moved by twice its uncertainty it is refused: --surface-energies-j-per-m2 is -0.01*,0: expected *")])
def test_wrong_surface_energies(words, message):
    expect(2, f"pulloff: --surface-energies-j-per-m2 is {message}", f"{ENERGIES} --surface-energies-j-per-m2 {words}")
    if "work" not in words:
        expect(2, "pulloff: --surface-energies-j-per-m2 is *: expected it with --from-physical, as it is in SI units",
               f"solve --tabor 1 --surface-energies-j-per-m2 {words.split()[0]}")
