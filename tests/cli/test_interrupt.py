"""After Ctrl-C a run ends with exit code 130 and keeps all finished points; the next run continues. So does a run whose disk fills up;
without memory the program ends with a message. It does not hang, and leaves no damaged file."""

import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import time

import conftest
import pytest
from conftest import expect, load, run, words_of


def limited(**limits):
    """An option of `run`: the limits of the process, in units of the shell's ulimit."""
    names = {"stack": (resource.RLIMIT_STACK, 1024), "files": (resource.RLIMIT_FSIZE, 1024), "space": (resource.RLIMIT_AS, 1024),
             "seconds": (resource.RLIMIT_CPU, 1)}
    return {"preexec_fn": lambda: [resource.setrlimit(names[name][0], 2 * (value * names[name][1],)) for name, value in limits.items()]}


def is_caught(process, number=signal.SIGINT):
    """Whether a process catches a signal."""
    caught = re.search(r"^SigCgt:\s*(\w+)", pathlib.Path(f"/proc/{process.pid}/status").read_text(), re.M)
    return bool(caught and int(caught[1], 16) >> number - 1 & 1)


def stopped(words, is_ready=is_caught, after=0.2, number=signal.SIGINT):
    """Starts the program with SIGINT ignored, as a shell starts background jobs, and sends it a signal so many seconds after it is ready.
    Returns what it printed; the exit code must be 130."""
    with subprocess.Popen(words_of(words), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN)) as process:
        for _ in range(2000):
            if process.poll() is not None or is_ready(process):
                break
            time.sleep(0.01)
        time.sleep(after)
        process.send_signal(number)
        out, err = process.communicate()
    assert process.returncode == 130, (words, out, err)
    return out, err


PARTS = """
name: {}
title: Spheres at random
suites: [smoke]
scene: {{outer_radius: inf, scheme: triangle, nodes: {}}}
sample: {{seed: 5, count: 6, keys: [{{key: tabor, from: 0.7, to: 1.3}}, {{key: radius, from: 70, to: 200}}]}}
want: [pull_off, curve]
"""


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_run(good, number):
    good.case("long", PARTS.format("long", 801))
    _, said = stopped("run --output run --jobs 2", lambda _: os.path.exists("run/good/record.json"), number=number)
    assert "pulloff: interrupted; finished points are kept in run" in said
    assert not os.path.exists("run/long/record.json")
    good.case("long", PARTS.format("long", 101))
    kept = "good: 1 point, 1 check: within (kept)"
    assert run("run --output run --jobs 2").err.splitlines() == [kept, "long: 6 points, 0 checks: within"]
    assert run("run --output run").err.splitlines() == [kept, "long: 6 points, 0 checks: within (kept)"]


def test_closed_forms(data):
    """Their evaluation can be interrupted, too. The points of the case are not solved again after that."""
    case = """
name: drawn
title: A point and many closed forms
suites: [smoke]
scene: {{tabor: 0, radius: 100, wavelength: 20, outer_radius: inf, scheme: ring, nodes: 101}}
want: [pull_off, curve]
lines:
  - name: along
    theory: guduru
    sweep:
      - {{key: amplitude, from: 1, to: 5, count: 9}}
      - {{key: tabor, from: 0.01, to: 5, count: {}, scale: log}}
"""
    data.case("drawn", case.format(10000))
    stopped("run drawn --output lines", lambda _: os.path.exists("lines/drawn/curve-0.csv"), after=0)  # written before the lines are made
    assert not os.path.exists("lines/drawn/line-along.csv") and not os.path.exists("lines/drawn/record.json")
    data.case("drawn", case.format(2))
    expect(0, "drawn: 1 point, 0 checks: within (kept)", "run drawn --output lines")
    assert os.path.exists("lines/drawn/record.json")


def test_a_solve_and_a_series():
    """A series in its first scene, which is traced, and later."""
    assert json.loads(stopped("solve --tabor 3 --scheme triangle --nodes 1501 --json")[0])["status"] == "interrupted"
    for scenes in "10 --to 11 --points 2 --amplitude 3 --wavelength 8 --tolerance 1e-8", "2 --to 5 --points 9000":
        for of in "folds", "pull-off":
            assert stopped(f"follow --of {of} --key tabor --from {scenes}", after=0.4) == ("", "pulloff: interrupted\n")


def without_times(path):
    return [line for line in pathlib.Path(path).read_text().splitlines()
            if not re.search(r'"(seconds|date|jobs|checksum)"|^ *[0-9.]+(e-[0-9]+)?,?$', line)]


def test_a_limit_of_the_file_size(data):
    """It acts like a disk that fills up in the middle of a line. The next run continues after what was written of it."""
    data.case("parts", PARTS.format("parts", 61).replace(", curve", ""))
    expect(0, "parts: 6 points, 0 checks: within", "run --jobs 1 --output whole")
    ended = run("run --jobs 1 --output limited", **limited(files=8))
    assert ended.code == 4
    assert re.search(r"^pulloff: limited/parts/points.jsonl cannot be written: (File too large|No space left on device)$", ended.err, re.M)
    kept = pathlib.Path("limited/parts/points.jsonl").read_text().count("\n")
    assert kept >= 1
    expect(0, f"parts: 6 points, 0 checks: within ({kept} point{'s' * (kept > 1)} kept)", "run --jobs 1 --output limited")
    assert without_times("limited/parts/record.json") == without_times("whole/parts/record.json")
    assert run("solve --tabor 0 --curve curve.csv", **limited(files=2)).code == 4 and not list(pathlib.Path().glob("curve.csv*"))
    # A point that ran out of memory is no result.
    expect(0, "parts: 3 of 6 points, 0 checks: within", "run --jobs 1 --output starved --points 0-2")
    conftest.edit("starved/parts/points.jsonl", '"status":"ok"', '"status":"no_memory"')
    assert run("run --jobs 1 --output starved").err.splitlines() == [
        "parts: 1 stored result was altered or damaged and is solved again", "parts: 6 points, 0 checks: within (2 points kept)"]


def test_little_memory():
    """A small stack suffices: a solve took 1.2 MB. With little address space, OpenBLAS used to request its work area for ever and to
    ignore SIGTERM."""
    assert run("solve --tabor 1 --want hysteresis,preload,diagnostics,curve,profile", **limited(stack=128)).code == 0
    if b"__asan_init" in pathlib.Path(conftest.PROGRAM).read_bytes():
        pytest.skip("the address sanitizer needs much address space")
    ends = {0: lambda ended: ended.count("^pull-off force 1.67066"),
            3: lambda ended: ended.err.startswith("pulloff: the solve failed: out of memory"),
            127: lambda ended: "error while loading shared libraries" in ended.err}
    for space in 60000, 100000, 140000, 180000, 200000, 250000, 300000, 400000:
        ended = run("solve --tabor 1", timeout=60, **limited(space=space))
        assert ends[ended.code](ended), (space, ended)
    assert ended.code == 0
    # Only condition numbers need OpenBLAS, and its work area.
    triangles = "solve --tabor 1 --scheme triangle --nodes 61"
    assert run(triangles, timeout=60, **limited(space=180000)).code == 0
    ended = run(triangles + " --want diagnostics", timeout=60, **limited(space=180000))
    assert ended.code == 3 and "OpenBLAS needs 129 MB of address space" in ended.err
