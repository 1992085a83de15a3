"""pulloff conform: a good solver, planted factors, and every kind of wrong answer."""

import os
import pathlib
import subprocess

import pytest
from conftest import ROOT, edit, expect
from solvers import manifest

SCENE = "[{key: tabor}, {key: radius}, {key: outer_radius}]"
FORCE, TIMES = "force at pull-off: ", "force at pull-off: the expected value times "
WITHIN = "ok +force at pull-off: within 5 % of the expected value in 4 scenes"
BETWEEN = "ok +between"


@pytest.fixture(autouse=True)
def _data(monkeypatch):
    monkeypatch.setenv("PULLOFF_DATA", str(ROOT))


def conform(code, mode, *patterns, scene=SCENE, time_limit=1, **more):
    """The exit code must be this one, and each pattern the beginning of a line."""
    name = manifest(mode, *more.pop("lines", ()), scene=scene, time_limit=time_limit, **more)
    return expect(code, "", f"conform {name} --output out").has(*("^" + pattern for pattern in patterns))


def is_running(words):
    return subprocess.run(["pgrep", "-f", words], capture_output=True).returncode == 0


def test_a_good_solver():
    numbers = [f"ok +{number} at pull-off: within" for number in ("force", "approach", "contact radius")]
    conform(0, "good", "ok +manifest: 3 quantities", "ok +empty request: ended", "ok +Bradley, tabor 0.01", "ok +JKR, tabor 3",
            "ok +between, tabor 0.8, radius 50", *numbers, "ok +repeats: 2 answers", "ok +a scene outside .*unsupported")
    assert not os.path.exists("out")
    os.mkdir("out")
    expect(0, "", "conform good.yaml --output out")
    assert os.listdir("out") == [], "a folder that was there before is left"
    edit("good.yaml", "protocol", "\ufeffprotocol")
    expect(0, "", "conform good.yaml --output out")


def test_answers_that_are_good():
    """It may change all in its own folder. A byte order mark before the first answer made it invalid."""
    conform(0, "slow", "ok +stopped after [123] of 4 answers")
    for mode in "scalar", "noise", "marked":
        conform(0, mode, WITHIN)
    conform(0, "inside", "ok +JKR", BETWEEN)
    for infinity in ".inf", "+.INF":
        conform(0, "good", WITHIN, scene=SCENE.replace("outer_radius", f"outer_radius, values: [{infinity}]"))


@pytest.mark.parametrize("mode, line", [
    ("shifted", "approach at pull-off: the expected value -1 eps"), ("sign", TIMES + r"-1 \(a wrong sign\)"), ("pi", TIMES + "pi in"),
    ("random", FORCE + "no common factor; worst for tabor 3"), ("approach_sign", r"approach at pull-off: the expected value times -1 \(a wrong sign\)"),
    ("half", TIMES + "1/2 in"), ("four_thirds", TIMES + "4/3 in"), ("radius", TIMES + "R in"), ("pi_radius", TIMES + "pi R in")])
def test_planted_factors(mode, line):
    """Each is named in one line."""
    said = conform(1, mode, "wrong +" + line, "1 finding is wrong$", *(["ok +" + FORCE] if "approach" in line else []))
    assert said.count("^wrong") == 1


@pytest.mark.parametrize("scene", [
    "tabor, from: 2}, {key: radius", "tabor, from: 6, to: 8}, {key: radius", "tabor, values: [0.65]}, {key: radius",
    "tabor, to: 0.005}, {key: radius", "tabor, values: [0]}, {key: radius", "tabor}, {key: radius, from: 2000",
    "tabor}, {key: radius, values: [77]", "tabor}, {key: radius, from: 60, to: 90}, {key: outer_radius, values: [400]"])
def test_scenes_of_a_manifest(scene):
    """A manifest of soft scenes alone was asked nothing, and passed with a force times pi. The scenes come from the values and the ranges
    of the manifest, whatever these are."""
    scene = f"[{{key: {scene}}}" + ("]" if "outer" in scene else ", {key: outer_radius}]")
    answered = [line for line in conform(0, "good", "ok +force at pull-off: within 5 % of the expected value in [1-4] scene", scene=scene).out.splitlines()
                if "answered" in line]
    assert len(answered) == len(set(answered))
    if "from: 2}" in scene:
        conform(1, "pi", "wrong +" + TIMES + "pi in", scene=scene)


def test_what_is_expected_between_the_rows_of_the_table():
    """It is what the program finds."""
    said = conform(0, "good", "ok +JKR, tabor 7, radius 100", scene=SCENE.replace("tabor", "tabor, values: [7]"))
    [expected] = [float(line.split(" expected ")[1]) for line in said.out.splitlines() if "radius 100: answered" in line]
    found = next(line for line in expect(0, "", "solve --tabor 7").out.splitlines() if line.startswith("pull-off force"))
    assert expected == pytest.approx(float(found.split()[2]), rel=0.01)


@pytest.mark.parametrize("scene", ["[{key: tabor, from: 12}, {key: radius}, {key: outer_radius}]", "[{key: tabor}, {key: radius}]",
                                   "[{key: tabor}, {key: radius}, {key: outer_radius, to: 5}]",
                                   "[{key: tabor, to: -1}, {key: radius}, {key: outer_radius}]"])
def test_nothing_that_is_known(scene):
    """The test does not pass, and says why."""
    conform(1, "good", "wrong +no scene was asked, so that no number is tested: expected a manifest that accepts", scene=scene)
    if "outer_radius" not in scene:
        conform(1, "good", "wrong +no scene was asked, .*outer_radius is inf: the manifest does not declare this key", scene=scene)


INVALID = "invalid: {}"


@pytest.mark.parametrize("mode, message", [
    ("skip", "no_answer"), ("half_line", INVALID.format("a line is not JSON")), ("twice", INVALID.format("two answers for repeat 1: expected one")),
    ("wrong_type", INVALID.format("pull_off.force is a text: expected a number")), ("lacking", INVALID.format("pull_off.approach is missing")),
    ("list", INVALID.format("a line is an array: expected an object")), ("nan", INVALID.format("a line is not JSON: .*near 'NaN'")),
    ("no_status", INVALID.format("status is missing: expected ok, unsupported or failed")), ("shorter", INVALID.format("the response became shorter")),
    ("null", INVALID.format("pull_off.force is missing or not a finite number")),
    ("stranger", INVALID.format("an answer has the id 4711, which was not asked")),
    ("crash", "crashed: the solver ended with exit status 3: a secret reason"),
    ("abort", "crashed: signal 11 .Segmentation fault. ended the solver"),
    ("gigabyte", "(crashed: signal 25|invalid: a line of the response has more)"),
    ("flood", "(invalid: it printed more than 256 MB|crashed: signal 13)"),
    ("hang", "timed_out: no answer within 1 s; the solver was stopped"), ("deaf", "timed_out"), ("spawn", "timed_out")])
def test_wrong_answers(mode, message):
    """The point gets a status, the others are judged. Nothing of the process group lives on."""
    conform(1, mode, "ok +Bradley", "wrong +JKR, .*: " + message, BETWEEN, time_limit=20 if mode in ("gigabyte", "flood") else 1)
    assert mode != "spawn" or not is_running("sleep 4711")


def test_no_answers():
    conform(1, "numberless", "ok +Bradley", "wrong +no answer has a number that can be compared", quantities="folds")
    conform(1, "nothing", "wrong +Bradley, .*: no_answer: the solver ended without an answer", "wrong +between, tabor 0.8, radius 50: no_answer")
    conform(1, "always_crash", "wrong +empty request", "wrong +Bradley, .*: crashed", "wrong +between, .*: no_answer: not asked any more",
            "note +request and response are in")
    conform(1, "link", "wrong +Bradley, .*: invalid: the response cannot be opened, or is a symbolic link")


def test_a_process_that_is_left():
    conform(0, "leave", BETWEEN, "note +processes that the solver left behind were killed")
    assert not is_running("sleep 4712")


def test_the_environment(monkeypatch):
    """The solver gets what it needs, and what its manifest names."""
    monkeypatch.setenv("SECRET", "hidden")
    monkeypatch.setenv("A_NAME", "shown")
    said = conform(1, "environment", "wrong +JKR, .*: crashed: the solver ended with exit status 5: A_NAME=shown HOME=.* LANG=C.UTF-8 ",
                   lines=["environment: [A_NAME, ABSENT]"])
    assert "hidden" not in said.out


@pytest.mark.parametrize("code, message, words", [
    (2, "conform needs one manifest (see pulloff conform --help)", "conform"), (4, "absent.yaml cannot be opened: *", "conform absent.yaml"),
    (4, "a folder for the solver cannot be created in locked/solvers/good", "conform good.yaml --output locked"),
    (2, "--knob is 7: expected no such option, as the manifest has no knob", "conform good.yaml --knob 7")])
def test_wrong_command_lines(code, message, words):
    manifest("good")
    os.makedirs("locked/solvers")
    os.symlink("/proc/self", "locked/solvers/good")  # in which no folder can be created
    expect(code, "pulloff: " + message, words)


@pytest.mark.parametrize("message, old, new", [
    ("1: protocol is pulloff-ask/2: expected pulloff-ask/1", "ask/1", "ask/2"),
    *((f"2: solver is {name}: expected letters*", "solver: good", f"solver: {name}") for name in ("../x", "pulloff")),
    ("3: command[1] is no-such-program: expected a program in PATH*", "/usr/bin/python3", "no-such-program"),
    ("3: command[1] is /no/such: expected a program that can be executed", "/usr/bin/python3", "/no/such"),
    *((f"5: can.scene[1].key is {key}: expected a key of the scene", "key: tabor", f"key: {key}") for key in ("tabour", "nodes")),
    ("5: can.scene[1].to is 0: expected a finite number >= from", "key: tabor", "key: tabor, from: 1, to: 0"),
    ("6: can.quantities[3] is steps: expected a list of names*", "contact_radius]", "steps]"),
    ("6: can.quantities[3] is folds: expected a quantity of stable*", "contact_radius]\n  unstable: true", "folds]\n  unstable: false"),
    ("7: can.unstable is maybe: expected true or false", "true", "maybe"),
    ("9: time_limit is 0: expected a finite number of seconds > 0", "time_limit: 2", "time_limit: 0"),
    ("3: colour is unknown: expected one of protocol, solver*", "command", "colour: red\ncommand")])
def test_wrong_manifests(message, old, new):
    name = pathlib.Path(manifest("good", scene=SCENE)).rename("changed.yaml")
    edit(name, old, new)
    expect(2, "pulloff: changed.yaml:" + message, "conform changed.yaml --output out")
