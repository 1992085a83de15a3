"""Cases that an external solver solves: verdicts, coverage, what is kept, shards, pins, explanations."""

import os
import pathlib
import re
import signal
import subprocess
import time

import pytest
from conftest import ROOT, edit, expect, words_of
from solvers import SCENE, manifest, record

JUDGED = """name: {}
title: Smooth spheres
suites: [own]
scene: {{radius: 100, outer_radius: inf}}
sweep:
  - together: [{{scheme: panel}}, {{scheme: triangle, nodes: 51}}]
  - {{key: tabor, values: [{}]}}
want: [pull_off]
checks:
  - {{quantity: pull_off_force, reference: reference/feng_pull_off.csv, tolerance: 1e-2, kind: abs, because: b}}
  - {{quantity: contact_radius, reference: reference/feng_pull_off.csv, tolerance: 1.5, kind: abs, because: b}}
  - {{quantity: folds, reference: reference/feng_landmarks.csv, tolerance: 1e-2, kind: abs, because: b}}
"""


@pytest.fixture(autouse=True)
def _data(monkeypatch):
    monkeypatch.setenv("PULLOFF_DATA", str(ROOT))
    write("judged", "0.5, 1, 2, 3")
    manifest("good")


def write(name, tabors):
    pathlib.Path(f"{name}.yaml").write_text(JUDGED.format(name, tabors))


def go(code, words, *lines):
    """Standard output or standard error must have a line with each of these patterns."""
    ended = expect(code, None, words)
    for line in lines:
        assert re.search(line, ended.out + ended.err, re.M), (line, ended)
    return ended


def of(solver, output="run", name="record"):
    return record(f"{output}/solvers/{solver}/judged/{name}.json")


def test_a_good_solver():
    """Its verdicts, its coverage, its record. Points that differ only in our mesh are asked once."""
    go(0, "verify judged.yaml --solver good.yaml --output run", r"^solver   good \(good.yaml\)", "^command  /usr/bin/python3",
       "^good:judged .*coverage 8/8 points, 16/24 checks", "^16 checks pass")
    made = of("good")
    assert made["solver"]["name"] == "good" and sum(p["asked"] for p in made["solver"]["processes"]) == 4
    assert made["points"][0]["pull_off"]["force"] == made["points"][4]["pull_off"]["force"] > 1.7
    assert not os.path.exists("run/judged") and not list(pathlib.Path("run").rglob("ask-*"))
    go(0, "run judged.yaml --solver good.yaml --output run", r"good:judged: 8 points, 16 checks: within \(kept\)")
    # Several solvers at once, one of them this program.
    go(0, "verify judged.yaml --solver good.yaml --solver pulloff --output run --points 0-3",
       "^good:judged .*coverage 4/8 points, 8/24 checks", r"^judged +24 +0")


def test_what_the_manifest_excludes():
    """It is left out, and the coverage says so. A solver of elastic bodies is not asked about a viscoelastic one."""
    manifest("part", answers="good", scene=SCENE % 1.5)
    why = "not asked: tabor is 2: outside the values that the manifest declares"
    go(0, "verify judged.yaml --solver part.yaml --output run", "^part:judged .*coverage 4/8 points, 8/24 checks",
       f"^part:judged: the manifest excludes 4 of 8 points; the first, .*tabor=2, is {why}$")
    assert of("part")["points"][2].items() >= {"status": "unsupported", "reason": why, "failed": False}.items()
    pathlib.Path("creeps.yaml").write_text("name: creeps\ntitle: A viscoelastic sphere\nsuites: [own]\nwant: [pull_off]\nscene: {tabor: 1, radius: 100, "
                                           "outer_radius: inf, scheme: panel, preload: 3, viscoelastic: 'sls:0.2', unload_speed: 1}\n")
    ended = subprocess.run(words_of("verify creeps.yaml --solver good.yaml --output run"), capture_output=True, text=True)
    assert "is not asked: viscoelastic is sls:0.2: the manifest does not declare this key\n" in ended.stdout + ended.stderr
    # Times that a solver does not report are left out: they made the time of a merged case null, and that of a failed test nan.
    for k in 1, 2:
        go(0, f"run judged.yaml --solver part.yaml --shard {k}/2 --output parts/{k}")
    go(0, "merge parts/1/solvers/part parts/2/solvers/part --solver part.yaml --output parts")
    assert of("part", "parts")["seconds"] > 0


@pytest.mark.parametrize("code, message, words", [
    (2, "--solver names good twice: expected each solver once", "verify judged.yaml --solver good.yaml --solver good.yaml"),
    (2, "explain takes one solver: expected --solver once", "explain judged.yaml --solver good.yaml --solver pulloff"),
    *((2, "--knob is 3: expected it with --solver MANIFEST, whose knob it is", f"run judged.yaml {solver} --knob 3")
      for solver in ("", "--solver pulloff", "--solver good.yaml@10")),
    (4, "absent.yaml cannot be opened: *", "run judged.yaml --solver absent.yaml"),
    # Only results of this program are pinned.
    (2, "unknown option --solver of bless *", "bless judged.yaml --solver good.yaml --reason first"),
    # With all values of its knob, merge would solve with those that the shards do not have.
    (2, "merge takes one value of the knob: expected --knob VALUE", "merge a b --solver good.yaml --knob all"),
    (2, "explain takes one value of the knob: expected --knob VALUE", "explain judged.yaml --solver good.yaml --knob all")])
def test_wrong_command_lines(code, message, words):
    expect(code, "pulloff: " + message, words)


def test_a_planted_factor():
    """verify fails, explain names it."""
    manifest("pi")
    go(1, "verify judged.yaml --solver pi.yaml --output run", "^    pulloff explain judged.yaml --point 0 --solver pi.yaml --output run")
    said = go(1, "explain judged.yaml --solver pi.yaml --output run",
              "fault +solver: the results of pi are the expected values times pi at all 8 points",
              "^  rerun      pulloff verify judged.yaml --points 0 --solver pi.yaml --fresh --verbose --output run$",
              "^  compare    pulloff solve --tabor 0.5 --radius 100 ")
    go(1, re.search("^  rerun      pulloff (.*)$", said.out, re.M)[1], "pull_off_force .* outside")
    made = of("pi")
    assert made["command"] == "pulloff run judged.yaml --solver pi.yaml" and "solver pi.yaml" in made["points"][0]["command"]


def test_explain_asks_only_for_the_points_that_it_explains():
    """It uses those that are known."""
    manifest("pi")
    go(1, "verify judged.yaml --solver pi.yaml --output few --points 0-1")
    go(1, "explain judged.yaml --solver pi.yaml --output few --point 2", r"pi:judged: 3 of 8 points, .*\(2 points kept\)",
       "the results of pi are the expected values times pi at all 3 points")
    made = of("pi", "few", "part")
    assert (made["solver"]["coverage"]["asked"], made["solver"]["coverage"]["points"]) == (3, 8)
    assert not os.path.exists("few/solvers/pi/judged/record.json") and not any(p["failed"] for p in made["points"])
    assert made["points"][5]["reason"] == "not asked: the run was limited to other points"
    go(0, "run judged.yaml --solver pi.yaml --output few")
    assert not os.path.exists("few/solvers/pi/judged/part.json"), "the record of all points replaces it"


@pytest.mark.parametrize("kind, fault", [
    ("published", "own.csv is a published table: check good first, .*then the publication and its digitisation"),
    ("oracle", "own.csv was computed by an independent method")])
def test_a_published_table(kind, fault):
    """Of a table of one's own that is published, explain does not say that it "was computed by an independent method"."""
    rows = [line.split(",") for line in (ROOT / "reference/feng_pull_off.csv").read_text().splitlines()]
    pathlib.Path("own.csv").write_text("tabor,force\n" + "".join(f"{row[0]},{1.02 * float(row[1])}\n" for row in rows if row[0] in ("1", "2")))
    expect(0, "", f"seal --what a --source b --kind {kind} --method c --units d --uncertainty 0.001 own.csv")
    pathlib.Path("own.yaml").write_text("""name: own
title: A table of one's own
suites: [own]
scene: {radius: 100, outer_radius: inf, scheme: panel}
sweep: [{key: tabor, values: [1, 2]}]
want: [pull_off]
checks: [{quantity: pull_off_force, reference: own.csv, tolerance: 0.01, kind: abs, because: b}]
""")
    go(1, "explain own.yaml --solver good.yaml --output own", f"fault +solver: {fault}")


@pytest.mark.parametrize("mode, solved, status", [("crash", 4, "crashed"), ("hang", 4, "timed_out"), ("skip", 6, "no_answer")])
def test_failures(mode, solved, status):
    """A failure is a status of its point; the others are judged. test_conform.py has the other kinds of failure. What ends the process does
    so again at the second point of the next one."""
    manifest(mode, start_limit=5)
    go(3, f"verify judged.yaml --solver {mode}.yaml --output run --jobs 1 --junit junit.xml")
    points = of(mode)["points"]
    assert [p["status"] for p in points].count("ok") == solved and points[1]["status"] == status
    text = pathlib.Path("junit.xml").read_text()
    assert len(re.findall('time="[0-9.]*"', text)) == text.count("time="), "a time for each test"


def test_a_program_that_is_killed():
    """It leaves no solver behind. tests/robust/store.py kills it at random moments. An answer that only the response of a killed process has
    is taken from there."""
    manifest("slow", time_limit=20)  # no answer is late, however busy the machine is
    write("long", "0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 1, 1.25, 1.5")
    store = pathlib.Path("lost/solvers/slow/long/points.jsonl")
    words = "run long.yaml --solver slow.yaml --output lost --jobs 1"
    with subprocess.Popen(words_of(words), stderr=subprocess.DEVNULL) as process:
        while process.poll() is None and not (store.exists() and store.stat().st_size):
            time.sleep(0.02)
        process.send_signal(signal.SIGKILL)
    time.sleep(0.2)
    assert subprocess.run(["pgrep", "-f", f"responder.py slow .*{os.getcwd()}"], capture_output=True).returncode
    store.unlink()
    go(0, words, r"slow:long: 24 points, .* \([1-9][0-9]* points kept\)")
    assert not list(pathlib.Path("lost").rglob("ask-*"))


def test_shards():
    """Merged, they are the whole."""
    go(0, "run judged.yaml --solver good.yaml --output run")
    for k in 1, 2:
        go(0, f"run judged.yaml --solver good.yaml --shard {k}/2 --output shards/{k}")
    shards = "merge shards/1/solvers/good shards/2/solvers/good"
    go(0, f"{shards} --solver good.yaml --output merged")
    merged, whole = (([(p["id"], p["status"], p["pull_off"], p["folds"]) for p in made["points"]], made["checks"], made["solver"]["coverage"])
                     for made in (of("good", "merged"), of("good")))
    assert merged == whole
    expect(2, "pulloff: * is of a run with another program*", shards)


def test_a_solver_that_locates_jumps_with_a_step():
    """The step is added to a tolerance and makes none slack. The explanation names it beside the tolerance of the case, which alone does not
    give the ratio. A solver of stable states alone is not asked for folds."""
    write("steps", "1, 2")
    edit("steps.yaml", "contact_radius, reference: reference/feng_pull_off.csv, tolerance: 1.5",
         "pull_off_approach, reference: reference/feng_pull_off.csv, tolerance: 1e-3")
    manifest("shifted", "approach_step: 1500", unstable="false")
    assert go(0, "verify steps.yaml --solver shifted.yaml --output run --verbose", "pull_off_approach .* within$").count("pull_off_approach .* slack") == 0
    manifest("shifted", "approach_step: 0.5", unstable="false")
    go(1, "explain steps.yaml --solver shifted.yaml --output run", "^  difference -1, 1.996 times the tolerance of 1e-3 abs$",
       "^  note       the approach step of the solver, 0.5, is added to the tolerance$")
    manifest("scalar")
    go(0, "verify judged.yaml --solver scalar.yaml --output run", "^scalar:judged .*coverage 8/8 points, 16/24 checks")
