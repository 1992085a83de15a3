"""pulloff solve --json prints one JSON document of the documented form and nothing else; the CSV tables, and the exit codes."""

import json
import math
import pathlib

import pytest
from conftest import document, expect, run

TRIANGLES = "solve --tabor 1 --scheme triangle --nodes 101"
CURVE = "position approach load energy energy_error_estimate contact_radius approach_rate load_rate unstable_modes"


def words(text):
    return set(text.split())


def refuse(word):
    raise ValueError(word)


def test_the_document_has_the_documented_form():
    text = expect(0, "", TRIANGLES + " --want curve,profile --json").out
    d = json.loads(text, parse_constant=refuse)
    assert d["schema"] == "pulloff/1" and d["status"] == "ok" and d["reason"] == ""
    assert d["input"]["outer_radius"] == "inf" and d["input"]["nodes"] == 101
    p = d["pull_off"]
    assert abs(p["force"] - 1.67067) < 1e-3 and abs(p["approach"] + 0.8734) < 2e-3
    assert set(p) == words("force approach contact_radius error_estimate approach_error_estimate contact_radius_error_estimate "
                           "contact_radius_other error_over_tolerance preload until")
    assert p["preload"] == {"approach": p["approach"], "load": -p["force"]}
    assert p["until"] == {"approach": None, "load": None}
    a = d["pull_off_any"]
    assert set(a) == words("force approach error_estimate approach_error_estimate preload complete searched")
    assert a["complete"] and a["force"] == p["force"] and a["searched"]["load"] > 0
    assert set(d["ended"]) == words("why approach load") and d["ended"]["why"] == "compressed"
    assert d["ended"]["approach"] == d["end"] and d["ended"]["load"] > 0
    assert [f["kind"] for f in d["folds"]] == ["jump_in", "jump_out"]
    assert [e["kind"] for e in d["extrema"]] == ["minimum"]
    assert set(d["folds"][0]) >= words("approach load energy kind contact_radius unstable_modes")
    assert set(d["work"]) == words("points newton_iterations factorizations kernel_evaluations nodes factorized_nodes meshes seconds")
    c = d["curve"]
    assert len(c) > 10 and set(c[0]) == words(CURVE)
    assert all(a["position"] <= b["position"] for a, b in zip(c, c[1:]))
    assert min(q["load"] for q in c) == -p["force"]
    assert len(d["profile"]) > 10 and set(d["profile"][0]) == words("radius gap traction")
    assert all(q["gap"] > -1 for q in d["profile"])
    assert math.isclose(d["profile_approach"], p["approach"])


def test_columns_of_the_tables():
    document(TRIANGLES + " --curve curve.csv --profile profile.csv")
    for name, columns in (("curve", "position,approach,load,energy,contact_radius,approach_rate,load_rate,unstable_modes,energy_error"),
                          ("profile", "radius,gap,traction")):
        assert columns in pathlib.Path(name + ".csv").read_text().splitlines()


@pytest.mark.parametrize("scheme", ["panel", "triangle --nodes 101"])
def test_diagnostics(scheme):
    d = document(f"solve --tabor 1 --scheme {scheme} --want diagnostics")["diagnostics"]
    assert set(d) == words("residual rounding undiagnosed states sensitivity moved energy_defect energy_defect_at reverse_trace seconds")
    assert [s["at"] for s in d["states"]] == ["start", "pull_off", "end", "fold", "fold"]
    for s in d["states"]:
        assert set(s) == words("at approach load nodes residual rounding condition bordered_condition")
        assert (s["condition"] > 1e4 * s["bordered_condition"]) == (s["at"] == "fold")
    assert 0 < d["residual"] < 1e-9 and d["undiagnosed"] == 0 and 0 < d["energy_defect"] < 1e-3
    assert set(d["sensitivity"]) == words("tabor amplitude wavelength radius residual rounding")
    assert set(d["moved"]) == words("solves failed force_change force_excess force_change_predicted digits_kept digits_predicted "
                                    "fold_change")
    w = d["reverse_trace"]
    assert bool(w) == (scheme == "panel")
    if w:
        assert set(w) == words("status reason points folds extrema same fold_approach_change fold_load_change "
                               "extremum_approach_change extremum_load_change excess")
        assert w["status"] == "ok" and w["same"] and (w["folds"], w["extrema"]) == (2, 1) and 0 < w["excess"] < 1
    assert d["moved"]["solves"] == 4 and d["moved"]["failed"] == 0 and d["moved"]["digits_kept"] > 11


def test_a_rigid_sphere():
    """Nothing is solved, and all digits are kept."""
    d = document("solve --tabor 0 --want diagnostics")["diagnostics"]
    assert d["states"] == [] and d["residual"] is None and d["moved"]["digits_kept"] > 14
    assert '"rigid": true' in expect(0, "", "solve --tabor 0 --json").out


@pytest.mark.parametrize("given", ["", "--profile cone:0.3 --coupling 0.1"])
def test_the_input_of_a_smooth_body_is_accepted_as_it_is_stated(given):
    """Amplitude 0 was refused without a wavelength, and the wavelength 0 that the document states beside it always."""
    smooth = document(f"solve --tolerance 1e-3 {given}")
    assert smooth["input"]["amplitude"] == smooth["input"]["wavelength"] == 0
    for waves in "--amplitude 0", "--amplitude 0 --wavelength 0":
        assert document(f"solve --tolerance 1e-3 {given} {waves}")["digest"] == smooth["digest"]


def test_the_printed_pull_off():
    assert expect(0, "", TRIANGLES).count("^pull-off force 1.67")


def test_a_solve_that_exceeds_the_time_limit_says_how_far_it_came():
    ended = expect(3, "pulloff: the solve failed: after 1e-09 s of processor time the trace has no point yet",
                   "solve --tabor 1 --time-limit 1e-9 --json")
    assert '"status": "out_of_time"' in ended.out
    expect(2, "pulloff: --time-limit is 0: expected a finite number > 0", "solve --time-limit 0")


def test_a_solve_repeats_to_the_last_bit():
    first, second = ([line for line in run("solve --tabor 2 --scheme triangle --nodes 101 --want curve --json").out.splitlines()
                      if "seconds" not in line] for _ in range(2))
    assert first == second
