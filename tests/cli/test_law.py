"""Traction–separation laws from the command line and in cases: limits that hold for every law, parameters that are refused,
and references that are of one law only."""

import pytest
from conftest import agree, document, expect


@pytest.mark.parametrize("message, words", [
    ("--law is mie:9: expected lennard-jones or mie:m,n or morse:a", "solve --law mie:9"),
    ("--mie-n is 3: expected a number > --mie-m, 9, and at most 60", "solve --law mie:9,3"),
    ("--mie-m is not given: expected it with the law mie", "solve --law mie --mie-n 9"),
    ("--mie-n is not given: expected it with the law mie", "solve --law mie --mie-m 4"),
    ("--morse-a is not given: expected it with the law morse", "solve --law morse"),
    ("--morse-a is 60: expected a number from 0.05 to 50", "solve --law morse:60"),
    ("--mie-m is 1.5: *unbounded surface*expected more than 2, or an outer radius", "solve --law mie:1.5,9"),
    ("--morse-a is 3: expected it with the law morse, not mie", "solve --law mie:4,10 --morse-a 3"),
    ("--mie-m is 3: expected it with the law mie, not lennard-jones", "solve --mie-m 3"),
    ("--key is law: *", "follow --key law --from 1 --to 2"),
    ("--mie-n is 4: expected it with the law mie, not morse", "follow --key mie-n --from 4 --to 5 --law morse:1"),
    # without a singularity the load of a rigid sphere grows without bound: the trace to an approach of 30 never ended
    ("*preload is 30: expected less than 3, the greatest approach of rigid bodies", "solve --tabor 0 --law morse:2 --preload 30")])
def test_wrong_laws(message, words):
    expect(2, "pulloff: " + message, words)


def test_preloads_of_a_law_without_singularity():
    expect(0, "", "solve --tabor 0 --law morse:2 --preload 2.9")
    expect(0, "", "solve --tabor 0 --law morse:2 --preload-load 1e9")


@pytest.mark.parametrize("law", ["mie:2.5,12", "morse:0.5", "morse:3"])
def test_limits(law):
    """A rigid sphere pulls off with 2 at approach 0 for every law (Derjaguin), a soft one tends to JKR."""
    rigid = document("solve --tabor 0 --law", law)["pull_off"]
    assert abs(rigid["force"] - 2) <= rigid["error_estimate"] < 1e-9 and abs(rigid["approach"]) < 1e-8
    soft = document("solve --tabor 14 --want diagnostics --law", law)
    assert 1.5 < soft["pull_off"]["force"] < 1.53
    d = soft["diagnostics"]
    assert d["residual"] < 1e-9 and d["energy_defect"] < 1e-3
    assert d["reverse_trace"]["same"] and len(soft["folds"]) >= 2
    assert soft["input"]["law"] == law.split(":")[0]


def test_the_mie_law_3_9_is_that_of_the_paper():
    paper, mie = document("solve --tabor 2.385"), document("solve --tabor 2.385 --law mie:3,9")
    assert abs(paper["pull_off"]["force"] - mie["pull_off"]["force"]) < 1e-9
    assert paper["input"]["mie_m"] is None and mie["input"]["mie_n"] == 9
    assert document("solve --tabor 2.385 --mie-n 9 --law mie --mie-m 3")["pull_off"] == mie["pull_off"], "set by parts"


@pytest.mark.once
@pytest.mark.parametrize("law", ["mie:4,10", "morse:1"])
def test_waves(law):
    """Of a cut surface, the tail of an unbounded one, and a mesh that stays."""
    for flags in "--outer-radius 60", "", "--scheme triangle --nodes 301 --outer-radius 60":
        assert document(f"solve --tabor 1.385 --amplitude 0.3 --wavelength 11 --law {law} {flags}")["status"] == "ok", flags


@pytest.mark.parametrize("law, cone", [("morse:3.145", "--profile cone:0.2198 --coupling 13.13"),
                                       ("morse:3.939", "--profile cone:0.07987 --coupling 3.876")])
def test_tips_under_laws_of_short_range(law, cone):
    """The tip of a cone lies between the axis and the first node of the mesh that a trace begins with: the mesh must see it.
    Soft cones tend to JKR."""
    lines = (line.split() for line in expect(0, "", "theory jkr " + cone).out.splitlines())
    force = next(float(line[1]) for line in lines if line[0] == "pull_off_force")
    found = document(f"solve --law {law} {cone}")
    assert found["status"] == "ok" and abs(found["pull_off"]["force"] / force - 1) < 1e-4


def test_a_parameter_that_is_followed_is_what_a_trace_of_that_scene_finds():
    points = document("follow --law mie:4,10 --key mie-n --from 7 --to 12 --points 6 --tabor 0.7 --tolerance 1e-5")["points"]
    assert [p["followed"] for p in points] == [False, True, True, True, True, False]
    for p in points[1:5:2]:
        solved = document(f"solve --tabor 0.7 --tolerance 1e-5 --law mie:4,{p['input']['mie_n']!r}")
        agree(p["pull_off"], solved["pull_off"], "force")


def test_references(good):
    """A table that names no law is of Lennard-Jones; one that names one is of that law."""
    path = good.folder / "cases/good.yaml"

    def verify(code, message, replaced, by):
        path.write_text(path.read_text().replace(replaced, by, 1))
        return expect(code, message, "verify good --output run --verbose")

    assert verify(1, "*outside*", "  tabor: 0\n", '  tabor: 0\n  law: "mie:4,10"\n').count("missing_reference")
    good.table("reference/table.csv", "tabor,law,force,approach", "0,mie:4;10,2,0", "0,mie:4;12,3,0")
    verify(0, "*within*", "", "")
    assert verify(1, "*outside*", "mie:4,10", "mie:4,12").count("expected *3|oracle *outside")
    good.table("reference/table.csv", "tabor,law,profile,waves,force,approach", "0,mie:4;12,cone:0.3,-,7,0",
               "0,mie:4;12,sphere,0.4@12,8,0", "0,mie:4;12,sphere,-,2,0")
    verify(0, "*within*", "", "")
    path.write_text(path.read_text().replace("mie:4,12", "mie:4,3"))
    expect(2, "*mie_n is 3: expected a number > mie_m*", "verify good --output run")
