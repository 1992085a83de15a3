#!/bin/sh
# pulloff solve --json prints one JSON document of the documented form and nothing else. Tests also the CSV tables and the
# exit codes.
# shellcheck disable=SC1091,SC2013,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
python=${PYTHON:-python3}

expect 0 '' solve --tabor 1 --scheme triangle --nodes 101 --want curve,profile --json
cat >look.py <<'LOOK'
import json, math, sys

def refuse(word):
    raise ValueError(word)

d = json.load(sys.stdin, parse_constant=refuse)
assert d["schema"] == "pulloff/1" and d["status"] == "ok" and d["reason"] == ""
assert list(d["input"]) == ["tabor", "amplitude", "wavelength", "radius", "outer_radius", "law", "mie_m", "mie_n", "morse_a",
                            "profile", "power_c", "power_n", "cone_t", "punch_b", "punch_r", "truncated_b", "truncated_r", "table_scale", "profile_file",
                            "waves", "scheme", "grading", "nodes", "tolerance", "approach_start", "approach_end", "preload", "preload_load",
                            "time_limit", "load_unit"], list(d["input"])
assert d["input"]["outer_radius"] == "inf" and d["input"]["nodes"] == 101
p = d["pull_off"]
assert abs(p["force"] - 1.67067) < 1e-3 and abs(p["approach"] + 0.8734) < 2e-3
assert set(p) == {"force", "approach", "contact_radius", "error_estimate",
                  "approach_error_estimate", "contact_radius_error_estimate", "contact_radius_other", "preload",
                  "until"}
assert p["preload"] == {"approach": p["approach"], "load": -p["force"]}
assert p["until"] == {"approach": None, "load": None}
a = d["pull_off_any"]
assert set(a) == {"force", "approach", "error_estimate", "approach_error_estimate", "preload", "complete",
                  "searched"}
assert a["complete"] and a["force"] == p["force"] and a["searched"]["load"] > 0
assert set(d["ended"]) == {"why", "approach", "load"} and d["ended"]["why"] == "compressed"
assert d["ended"]["approach"] == d["end"] and d["ended"]["load"] > 0
assert [f["kind"] for f in d["folds"]] == ["jump_in", "jump_out"]
assert [e["kind"] for e in d["extrema"]] == ["minimum"]
assert set(d["folds"][0]) >= {"approach", "load", "energy", "kind", "contact_radius", "unstable_modes"}
assert set(d["work"]) == {"points", "newton_iterations", "factorizations", "kernel_evaluations",
                          "nodes", "factorized_nodes", "meshes", "seconds"}
c = d["curve"]
assert len(c) > 10 and set(c[0]) == {"position", "approach", "load", "energy",
                                     "energy_error_estimate", "contact_radius", "approach_rate", "load_rate", "unstable_modes"}
assert all(a["position"] <= b["position"] for a, b in zip(c, c[1:]))
assert min(q["load"] for q in c) == -p["force"]
assert len(d["profile"]) > 10 and set(d["profile"][0]) == {"radius", "gap", "traction"}
assert all(q["gap"] > -1 for q in d["profile"])
assert math.isclose(d["profile_approach"], p["approach"])
LOOK
check 'the document has the documented form' "$python" look.py <"$work/stdout"
expect 0 '' solve --tabor 1 --scheme triangle --nodes 101 --json --curve curve.csv --profile profile.csv
check 'the curve has its columns' grep -q '^position,approach,load,energy,contact_radius,approach_rate,load_rate,unstable_modes,energy_error$' \
  curve.csv
check 'the profile has its columns' grep -q '^radius,gap,traction$' profile.csv

# Diagnostics alone, with a fold, with panels, on a fixed mesh, and for a rigid sphere.
cat >diagnosed.py <<'LOOK'
import json, sys

d = json.load(sys.stdin)["diagnostics"]
assert set(d) == {"residual", "rounding", "undiagnosed", "states", "sensitivity", "moved", "energy_defect",
                  "energy_defect_at", "reverse_trace", "seconds"}, list(d)
assert [s["at"] for s in d["states"]] == ["start", "pull_off", "end", "fold", "fold"]
for s in d["states"]:
    assert set(s) == {"at", "approach", "load", "nodes", "residual", "rounding", "condition",
                      "bordered_condition"}
    assert (s["condition"] > 1e4 * s["bordered_condition"]) == (s["at"] == "fold")
assert 0 < d["residual"] < 1e-9 and d["undiagnosed"] == 0 and 0 < d["energy_defect"] < 1e-3
assert set(d["sensitivity"]) == {"tabor", "amplitude", "wavelength", "radius", "residual", "rounding"}
assert set(d["moved"]) == {"solves", "failed", "force_change", "force_excess", "force_change_predicted", "digits_kept",
                           "digits_predicted", "fold_change"}
if d["reverse_trace"]:
    w = d["reverse_trace"]
    assert set(w) == {"status", "reason", "points", "folds", "extrema", "same", "fold_approach_change",
                      "fold_load_change", "extremum_approach_change", "extremum_load_change", "excess"}
    assert w["status"] == "ok" and w["same"] and (w["folds"], w["extrema"]) == (2, 1) and 0 < w["excess"] < 1
assert bool(d["reverse_trace"]) == (sys.argv[1] == "panel")
assert d["moved"]["solves"] == 4 and d["moved"]["failed"] == 0 and d["moved"]["digits_kept"] > 11
LOOK
for scheme in panel 'triangle --nodes 101'; do
  # shellcheck disable=SC2086
  expect 0 '' solve --tabor 1 --scheme $scheme --want diagnostics --json
  check "diagnostics of $scheme" "$python" diagnosed.py ${scheme%% *} <"$work/stdout"
done
expect 0 '' solve --tabor 0 --want diagnostics --json
check 'rigid: nothing is solved, and all digits are kept' "$python" -c 'import json, sys
d = json.load(sys.stdin)["diagnostics"]
assert d["states"] == [] and d["residual"] is None and d["moved"]["digits_kept"] > 14' <"$work/stdout"
expect 0 '' solve --tabor 1 --scheme triangle --nodes 101
check 'the printed result has the pull-off' grep -q '^pull-off force 1.67' "$work/stdout"
expect 0 '' solve --tabor 0 --json
check 'rigid' grep -q '"rigid": true' "$work/stdout"

# A solve that exceeds the time limit states the point that it reached.
expect 3 'pulloff: the solve failed: after 1e-09 s of processor time the trace is at approach -*, load *' \
  solve --tabor 1 --time-limit 1e-9 --json
check 'the JSON document states it' grep -q '"status": "out_of_time"' "$work/stdout"
expect 2 'pulloff: --time-limit is 0: expected a finite number > 0' solve --time-limit 0

# A repeated solve gives the same numbers to the last bit.
"$program" solve --tabor 2 --scheme triangle --nodes 101 --want curve --json | grep -v seconds >first
"$program" solve --tabor 2 --scheme triangle --nodes 101 --want curve --json | grep -v seconds >second
check 'a solve repeats to the last bit' cmp first second
finish
