"""The printed tables contain the numbers of the JSON document, under the right headings."""

import math
import re

from conftest import document, expect

HEADING = re.compile(r"contact radius|energy lost|unstable modes|\S+")
LABELS = {"point", "jump", "phase", "fold", "obtained"}  # columns of words


def both(words):
    """The lines that a command prints, and its document."""
    return expect(0, "", words).out.splitlines(), document(words)


def tables(lines, *first):
    """The tables whose first heading is one of these, read by the right edges of their headings: for each its rows, as lists of
    (heading, cell)."""
    found, edges = [], None
    for line in lines:
        if line.split() and line.split()[0] in first:
            edges = [(m.end(), m.group()) for m in HEADING.finditer(line) if m.group() not in LABELS]
            found.append([])
        elif edges and (line[:1].isalnum() or line[:1] == " " and line.strip()):
            if line.startswith("work"):
                break
            begin, row = 0, []
            for edge, name in edges:
                row.append((name, line[begin:edge].split()[-1] if line[begin:edge].split() else ""))
                begin = edge
            found[-1].append((line.split(), row))
    return found


def same(cell, value, places):
    """Whether a cell shows a number to so many significant digits; an unknown number is blank."""
    if value is None or not cell:
        return value is None and not cell
    return math.isclose(float(cell), value, rel_tol=10.0 ** (1 - places), abs_tol=1e-9)


def check(row, *wanted):
    for (name, cell), (heading, value, places) in zip(row, wanted, strict=True):
        assert name == heading
        assert cell == value if isinstance(value, str) else same(cell, value, places), (row, heading, value)


def landmark(found):
    return (("approach", found["approach"], 9), ("error", found["error_estimate"], 2), ("load", found["load"], 9),
            ("error", found["load_error_estimate"], 2), ("contact radius", found["contact_radius"], 6))


def words_of(lines, start):
    return next(line for line in lines if line.startswith(start)).replace(",", "").split()


def test_special_points_and_jumps_of_solve():
    lines, d = both("solve --tabor 2.385 --preload 0.7 --want hysteresis")
    special, held, loaded = tables(lines, "point", "jump")
    assert len(special) >= len(d["folds"]) + len(d["extrema"])
    for (words, row), found in zip(special, d["folds"] + d["extrema"]):
        assert words[0] == found["kind"]
        check(row, *landmark(found), ("unstable modes", found["unstable_modes"], 9))
    for rows, control in ((held, "displacement_control"), (loaded, "load_control")):
        jumps = d["hysteresis"][control]["jumps"]
        for (words, row), jump in zip(rows, jumps):
            ends = [jump[end]["approach"] for end in ("before", "after")]
            assert words[:2] == [jump["label"], jump["phase"]]
            check(row, ("approach", "apart" if ends[0] is None else ends[0], 7), ("to", "apart" if ends[1] is None else ends[1], 7),
                  ("load", jump["before"]["load"], 7), ("to", jump["after"]["load"], 7),
                  ("energy lost", "boundless" if jump["energy_lost"] is None else jump["energy_lost"], 5),
                  ("error", jump["energy_lost_error_estimate"], 2))
        assert len(jumps) == 2
    p = d["pull_off"]
    line = words_of(lines, "pull-off force")
    assert same(line[2], p["force"], 9) and same(line[5], p["approach"], 9) and same(line[8], p["contact_radius"], 6)
    line = words_of(lines, "errors")
    assert same(line[2], p["error_estimate"], 2) and same(line[4], p["approach_error_estimate"], 2)
    h = d["hysteresis"]["displacement_control"]
    held = next(line for line in lines if line.startswith("displacement control"))
    for number, value in zip(map(float, re.findall(r"-?\d[\d.e+-]*", held)), (
            h["preload"]["approach"], h["preload"]["load"], h["pull_off"]["force"], h["pull_off"]["approach"], h["energy_lost"],
            float(f"{h['energy_lost_error_estimate']:.2g}")), strict=True):
        assert math.isclose(number, value, rel_tol=1e-5), held


def test_pull_off_and_folds_of_follow():
    words = "follow --key tabor --from 1.35 --to 0.92 --points 3 --scale linear --radius 87 --tolerance 1e-5"
    lines, d = both(words)
    (rows,) = tables(lines, "tabor")
    assert len(rows) == len(d["points"]) == 3
    for (words_of_row, row), point in zip(rows, d["points"]):
        p = point["pull_off"]
        check(row, ("tabor", point["input"]["tabor"], 6), ("force", p["force"], 9), ("error", p["error_estimate"], 2),
              ("approach", p["approach"], 9), ("error", p["approach_error_estimate"], 2), ("contact radius", p["contact_radius"], 6),
              ("factorisations", point["work"]["factorizations"], 9))
        assert ("followed" if point["followed"] else "traced") in words_of_row
    lines, d = both(words + " --of folds")
    (rows,) = tables(lines, "fold")
    assert len(rows) == 2 * len(d["points"]) == 6
    for k, (words_of_row, row) in enumerate(rows):
        point = d["points"][k % 3]
        assert words_of_row[0] == point["folds"][k // 3]["kind"]
        check(row, ("tabor", point["input"]["tabor"], 6), *landmark(point["folds"][k // 3]))


def test_results_that_are_too_long_for_the_terminal_are_mentioned():
    printed, d = both("solve --tabor 1 --tolerance 1e-4 --want curve,profile,diagnostics")
    lines = {words[0]: words for words in map(str.split, printed) if words}
    assert lines["curve"][1] == str(len(d["curve"])) and lines["profile"][1] == str(len(d["profile"]))
    assert same(lines["profile"][5].rstrip(";"), d["profile_approach"], 8)
    (held,) = d["contact"]["held"]
    assert held["inner"] == 0 and same(lines["annuli"][5], held["outer"], 6)
    assert same(lines["checks"][6].rstrip(";"), d["diagnostics"]["residual"], 2)
    assert " ".join(lines["reverse"][1:]) == "status ok: the reverse trace found the same special points"
    assert lines["ended"][3].rstrip(",") and same(lines["ended"][3].rstrip(","), d["ended"]["approach"], 6)
    assert same(lines["ended"][5].rstrip(":"), d["ended"]["load"], 6)
