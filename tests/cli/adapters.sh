#!/bin/sh
# The example solvers of reference/solvers conform, on coarse meshes, and solve two scenes of the case smoke within its
# tolerances; the deliberately wrong one does not, and its mistake is named. The one in GNU Octave is tested where Octave is
# installed.
# shellcheck disable=SC1091,SC2154
. "$(dirname "$0")/lib.sh"
export PULLOFF_DATA="$here/../.."
solvers=$PULLOFF_DATA/reference/solvers
for pair in newton:126 copson:1 relax:126 triangles:126; do
  expect 0 '' conform "$solvers/${pair%:*}.yaml" --knob "${pair#*:}" --output out
done
for pair in newton:501 copson:1 relax:126 triangles:501; do
  "$program" verify smoke --points 1-2 --solver "$solvers/${pair%:*}.yaml" --knob "${pair#*:}" --output out --jobs 1 \
    >stdout 2>stderr
  check "$pair solves smoke: $(cat stdout stderr)" test $? -eq 0
  check "$pair: all checks are made: $(cat stdout)" grep -qE '^(4|10) checks pass( \([0-9]* slack\))?, 0 do not' stdout
done
# On a mesh that does not resolve the contact edge, the branch has dozens of spurious folds. A step that ends on another part
# of it must not turn the continuation back.
cat >coarse.yaml <<'END'
name: coarse
title: A wavy sphere on 125 elements
suites: [own]
scene: {tabor: 5, amplitude: 10, wavelength: 20, radius: 100, outer_radius: 100, scheme: panel, approach_start: -15, approach_end: 12}
want: [pull_off]
checks:
  - {quantity: pull_off_force, reference: reference/wavy_pull_off.csv, tolerance: 0.31, kind: abs, because: the error of 125 elements is 0.2995}
END
for name in newton triangles; do
  "$program" verify coarse.yaml --solver "$solvers/$name.yaml" --knob 126 --output out >stdout 2>stderr
  check "$name on 125 elements: $(cat stdout stderr)" test $? -eq 0
done
# A jump over unstable stretches of the branch ends at a state of rest.
cat >jumps.yaml <<'END'
name: jumps
title: The jumps of Figure 12
suites: [own]
scene: {tabor: 4, amplitude: 0.4, wavelength: 10, radius: 100, outer_radius: 100, scheme: panel, preload: 4}
want: [pull_off, hysteresis]
checks:
  - {quantity: jumps, reference: reference/wavy_jumps.csv, tolerance: 0.12, kind: abs, because: 250 elements resolve the contact edge only coarsely}
  - {quantity: hysteresis_force, reference: reference/wavy_loops.csv, tolerance: 0.01, kind: abs, because: the error of 250 elements is half of this}
END
"$program" verify jumps.yaml --solver "$solvers/relax.yaml" --knob 251 --output out >stdout 2>stderr
check "relax passes over the jumps: $(cat stdout stderr)" test $? -eq 0
if command -v octave-cli >/dev/null; then
  expect 0 '' conform "$solvers/paper.yaml" --knob 501 --output out
fi
expect 1 '' conform "$solvers/wrong.yaml" --knob four_thirds --output out
check 'the mistake is named' grep -q '^wrong *force at pull-off: the expected value times 4/3 in 4 scenes' stdout
finish
