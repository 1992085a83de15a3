"""pulloff theory: the closed forms by name, as JSON and as text; the message for missing or wrong options is one line."""

import math
import pathlib

import pytest
from conftest import document, expect


def near(key, value, tolerance, words):
    d = document("theory " + words)
    assert d["schema"] == "pulloff/1" and abs(d[key] - value) <= tolerance, d


@pytest.mark.parametrize("key, value, tolerance, words", [
    ("pull_off_force", 19.9243, 1e-4, "guduru --tabor 5 --amplitude 10 --wavelength 20 --radius 100"),
    ("pull_off_force", 0.7410559, 1e-7, "rigid --alpha 0.25 --amplitude 1"),
    ("pull_off_force", 1.992148, 1e-6, "rigid --alpha 1e-4 --amplitude 1"),
    ("pull_off_force", 1.5, 1e-14, "jkr --tabor 2.385"),
    ("last_load", -0.83333333333333, 1e-13, "jkr --tabor 2.385"),
    ("pull_off_force", 2, 0, "dmt --tabor 2.385"),
    ("load", 4 / 3 * 12.5**0.5 * 125 / (math.pi * 100**2) - 2, 1e-15, "dmt --tabor 2 --contact-radius 5"),  # 4 E* a^3/(3 R)
    ("approach", 0.25, 1e-16, "dmt --tabor 2 --contact-radius 5"),
    ("pull_off_force", 2.38264112209, 1e-11, "jkr --tabor 5 --amplitude 1 --wavelength 20"),  # as guduru
    ("pull_off_least_gap", 0, 0, "jkr --tabor 5 --amplitude 1 --wavelength 20"),
    ("bound", 8.57604, 1e-6, "compactness --amplitude 1 --wavelength 20"),
    ("area_ratio", 1.0986960440, 1e-9, "persson-tosatti --amplitude 2 --wavelength 20"),
    ("area_ratio_printed", 1.0314159265, 1e-9, "persson-tosatti --amplitude 2 --wavelength 20"),
    ("peak_distance", 1.2009369551760027, 1e-15, "lennard-jones"),
    ("load", -2, 1e-15, "bradley --approach 0"),
    ("traction", -1.02639201129570, 1e-13, "lennard-jones --gap 0.2"),  # -(8/3) (x^3 - x^9), x = 1/1.2
    ("part_of_bradley", 1, 1e-4, "rumpf-rabinowicz --alpha 1e-7 --radius 100"),
    ("composite_radius", 48.4, 1, "crest --amplitude 0.1 --wavelength 19.4"),
    # amplitude 0 is the smooth sphere and is accepted
    ("pull_off_force", 1.5, 1e-14, "guduru --tabor 2.385 --amplitude 0"),
    ("pull_off_approach", -1.8445993817945, 1e-12, "guduru --tabor 2.385 --amplitude 0"),
    ("effective_work", 1, 0, "kesari-lew --tabor 2.385 --amplitude 0 --wavelength 20"),
    ("effective_work", 1, 0, "persson-tosatti --amplitude 0"),
    ("pull_off_force", 2, 0, "rigid --amplitude 0"),
    ("composite_radius", 77, 1e-13, "crest --amplitude 0 --radius 77"),
    ("critical_radius", 0, 0, "compactness --amplitude 0"),
    # extreme ratios of lengths: GSL's error handler used to end the program, or the search for the deepest wave did not end
    ("load", 3.79606689822e43, 1e33, "guduru --tabor 5 --amplitude 1 --wavelength 10 --contact-radius 1e16"),
    ("pull_off_force", 2.10744797525e12, 10, "guduru --tabor 5 --amplitude 1 --wavelength 1e-12"),
    ("pull_off_force", 210780002.771, 1e-3, "guduru --tabor 5 --amplitude 1 --wavelength 1e-8"),
    # the forms of any profile: the cone, the sphere as a power, the peak of the law
    ("pull_off_force", 10.1321183642338, 1e-12, "jkr --profile cone:0.3 --coupling 0.05"),
    ("pull_off_least_gap", 0, 0, "jkr --profile cone:0.3 --coupling 0.05"),
    ("pull_off_force", 1.5, 1e-13, "jkr --profile power:0.005,2 --radius 100 --tabor 2.385"),
    ("approach_rate", 0, 1e-12, "jkr --profile cone:0.3 --coupling 0.05 --contact-radius 0.35367765131532297"),
    ("tension", 1.0264004785593346, 1e-15, "maugis --tabor 1"),
    ("pull_off_force", 2, 1e-12, "rigid --law morse:1.7"),
    ("pull_off_force", 137.425431733702511, 1e-10, "rigid --profile punch:5,20 --law morse:3")])
def test_values(key, value, tolerance, words):
    near(key, value, tolerance, words)


@pytest.mark.parametrize("scene", [
    "--profile cone:0.3 --coupling 0.05", "--profile power:1,3 --coupling 0.05", "--profile punch:3,10 --coupling 0.05",
    "--profile truncated:3,10 --coupling 0.05", "--profile sphere", "--profile cone:0.3 --coupling 0.05 --wave 1,20",
    "--amplitude 1 --wavelength 20", "--profile-file tip.csv --coupling 0.05"])
def test_rates_at_the_beginning_of_the_jkr_curve(scene):
    """The load rate was computed as 0 times infinity, and the command failed. From contact radius 0 on the load falls as
    a^(3/2) and the approach as sqrt(a): nearby the rates are proportional to sqrt(a) and to its inverse."""
    pathlib.Path("tip.csv").write_text("r,gap\n" + "".join(f"{r},{0.3 * r + 0.01 * r**2}\n" for r in range(9)))
    jkr = f"theory jkr {scene} --contact-radius"
    first = document(jkr, 0)
    assert (first["load"], first["approach"], first["load_rate"], first["approach_rate"]) == (0, 0, 0, None)
    near, nearer = (document(jkr, a) for a in (1e-10, 1e-12))
    assert abs(nearer["load_rate"] / near["load_rate"] - 0.1) < 1e-4 > abs(nearer["approach_rate"] / near["approach_rate"] - 10) / 100
    assert nearer["load_rate"] < 0 > nearer["approach_rate"]


def test_printed_results():
    assert expect(0, "", "theory kesari-lew --amplitude 0").count("^johnson_parameter +-$"), "an infinite parameter is a dash"
    assert expect(0, "", "theory kesari-lew --amplitude 1 --wavelength 20 --contact-radius 30").count("^effective_work ")


WAVE = " --amplitude 1 --wavelength 20"
FAR = "*expected values of more similar size"


@pytest.mark.parametrize("message, words", [
    ("theory needs the name of a closed form: expected bradley, *", ""),
    ("no closed form is named alchemy: expected bradley, *", "alchemy"),
    # the parameters that each form needs: waves, an elastic half-space, or both
    *((f"theory {form} needs --amplitude and --wavelength", form)
      for form in ("guduru", "kesari-lew", "persson-tosatti", "compactness", "crest")),
    *(("--tabor is 0: expected a finite number > 0", form + " --tabor 0" + WAVE) for form in ("guduru", "kesari-lew", "persson-tosatti")),
    ("theory rigid needs --amplitude", "rigid --alpha 1"),
    ("theory rigid needs --alpha, or *", "rigid --amplitude 1"),
    ("--tabor is 0: expected a finite number > 0", "jkr --tabor 0"),
    ("--approach is 1: expected a finite number < 1", "bradley --approach 1"),
    ("--radius is nan: expected a finite number > 0", "jkr --radius nan"),
    ("--gap is -1: expected a finite number > -1", "lennard-jones --gap -1"),
    ("unexpected argument more of theory*", "jkr more"),
    ("pull_off_force of theory guduru cannot be computed: " + FAR, "guduru --tabor 5 --amplitude 1 --wavelength 1e-300"),
    ("pull_off_force of theory rigid cannot be computed: " + FAR, "rigid --amplitude 1 --wavelength 1e-300"),
    ("load of theory jkr cannot be computed: " + FAR, "jkr --contact-radius 1e200"),
    ("Maugis-Dugdale needs a full disc of contact *", "maugis --wave 3,10 --tabor 0.5"),
    ("Maugis-Dugdale needs *, but the gap of the ring is -0.005* at radius 9.0*", "maugis --wave 0.3,12 --contact-radius 5"),
    ("--wave has no effect on theory guduru: *", "guduru --wave 1,20"),
    ("--tension is 0: expected a finite number > 0", "maugis --tension 0"),
    ("--coupling is 0: expected a finite number > 0", "jkr --profile cone:0.3 --coupling 0"),
    ("--contact-radius-m has no effect on theory bradley: expected only --radius-m or --approach-m",
     "bradley --from-physical --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 1e-7 --contact-radius-m 1e-9")])
def test_wrong_command_lines(message, words):
    expect(2, "pulloff: " + message, "theory " + words)


@pytest.mark.parametrize("form", ["rigid", "rumpf-rabinowicz", "compactness", "crest"])
def test_forms_of_waves_alone(form):
    expect(0, "", f"theory {form}" + WAVE)


ELASTIC = "only --tabor, --coupling, --amplitude, --wavelength, --radius or --contact-radius"
STATES = "--load, --approach, --contact-radius or --curve"
GUDURU = "only --tabor, --coupling, --amplitude, --wavelength, --radius, --preload, --preload-load, " + STATES
IDLE = (  # name, flags, expected, the other options
    ("jkr", "--alpha --gap", "only --tabor, --coupling, --amplitude, --wavelength, --radius, --profile, --profile-file, --wave, --preload, "
     "--preload-load, " + STATES, ""),
    ("dmt", "--amplitude --wavelength --alpha --gap", "only --tabor, --coupling, --radius, " + STATES, ""),
    ("lennard-jones", "--tabor --amplitude --wavelength --radius --alpha --approach --contact-radius", "only --gap", ""),
    ("bradley", "--tabor --amplitude --wavelength --radius --alpha --contact-radius --gap", "only --approach", ""),
    ("guduru", "--alpha --gap", GUDURU, "--amplitude 1 --wavelength 9"),
    ("kesari-lew", "--alpha --approach --gap", ELASTIC, "--amplitude 1 --wavelength 9"),
    ("compactness", "--tabor", "only --amplitude, --wavelength or --radius", "--amplitude 1 --wavelength 9"),
    ("crest", "--tabor", "only --amplitude, --wavelength or --radius", "--amplitude 1 --wavelength 9"),
    ("persson-tosatti", "--contact-radius", "only --tabor, --coupling, --amplitude, --wavelength or --radius",
     "--amplitude 1 --wavelength 9"),
    ("rigid", "--radius --wavelength", "only --amplitude, --approach or --alpha", "--alpha 1 --amplitude 1"),
    ("rumpf-rabinowicz", "--amplitude --approach", "only --radius or --alpha", "--alpha 1"))


@pytest.mark.parametrize("name, flag, expected, more",
                         [(name, flag, expected, more) for name, flags, expected, more in IDLE for flag in flags.split()])
def test_an_option_that_has_no_effect_is_refused(name, flag, expected, more):
    expect(2, f"pulloff: {flag} has no effect on theory {name}*: expected {expected}", f"theory {name} {more} {flag} 0.7")


@pytest.mark.parametrize("code, message, words", [
    (2, "--amplitude is missing: expected it beside --wavelength", "solve --wavelength 9"),
    (2, "--amplitude is missing: expected it beside --wavelength", "follow --key tabor --from 1 --to 2 --wavelength 9"),
    (2, "--amplitude is missing: expected it beside --wavelength", "follow --key wavelength --from 1 --to 2"),
    (2, "--checkpoint-every has no effect on --of folds: expected *",
     "follow --key tabor --from 1 --to 2 --of folds --checkpoint-every 3"),
    (3, "the solve failed: the rigid load would be the sum of 2e+10 half waves up to radius 100, *",
     "solve --tabor 0 --amplitude 1 --wavelength 1e-8 --outer-radius 100"),
    # a fixed mesh on the unbounded surface resolves a limited number of waves
    (3, "the solve failed: * waves beyond radius * must be resolved, with 12 nodes each: * expected *",
     "solve --tabor 0.1 --scheme ring --amplitude 10 --wavelength 0.3 --nodes 2500"),
    (3, "the solve failed: elements of length * cannot represent waves of length 0.1; expected at least * nodes, *",
     "solve --scheme ring --amplitude 0.01 --wavelength 0.1 --nodes 100")])
def test_options_without_effect_and_scenes_that_other_verbs_refuse(code, message, words):
    expect(code, "pulloff: " + message, words)


@pytest.mark.parametrize("wavelength", ["0.02", "1e-8", "1e-150"])
def test_rigid_waves_end(wavelength):
    assert document("solve --tabor 0 --amplitude 1.3 --wavelength " + wavelength)["status"] == "ok"


def test_for_very_short_waves_the_rigid_load_is_their_mean():
    """The solver and the closed form compute it independently."""
    force = document("solve --tabor 0 --amplitude 1.3 --wavelength 0.02")["pull_off"]["force"]
    near("pull_off_force", force, 1e-10, "rigid --amplitude 1.3 --wavelength 0.02")
