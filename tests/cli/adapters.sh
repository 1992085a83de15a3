#!/bin/sh
# An example solver of reference/solvers conforms, on a coarse mesh, and solves a scene of the case smoke within its
# tolerances; the deliberately wrong one does not, and its mistake is named. The one in GNU Octave is tested where Octave is
# installed. Usage: adapters.sh PROGRAM SOLVER
# shellcheck disable=SC1091,SC2154
solver=$2
. "$(dirname "$0")/lib.sh"
export PULLOFF_DATA="$here/../.."
manifest=$PULLOFF_DATA/reference/solvers/$solver.yaml

conforms() { expect 0 '' conform "$manifest" --knob "$1" --output out; }

solves_smoke() { # KNOB
  "$program" verify smoke --points 2 --solver "$manifest" --knob "$1" --output out --jobs 1 >stdout 2>stderr
  check "$solver:$1 solves smoke: $(cat stdout stderr)" test $? -eq 0
  check "$solver:$1: all checks are made: $(cat stdout)" grep -qE '^[1-9][0-9]* checks pass( \([0-9]* slack\))?, 0 do not' stdout
}

# On a mesh that does not resolve the contact edge, the branch has dozens of spurious folds. A step that ends on another part
# of it must not turn the continuation back.
passes_spurious_folds() {
  cat >coarse.yaml <<'END'
name: coarse
title: A wavy sphere on 125 elements
suites: [own]
scene: {tabor: 5, amplitude: 10, wavelength: 20, radius: 100, outer_radius: 100, scheme: panel, approach_start: -15, approach_end: 12}
want: [pull_off]
checks:
  - {quantity: pull_off_force, reference: reference/wavy_pull_off.csv, tolerance: 0.31, kind: abs, because: the error of 125 elements is 0.2995}
END
  "$program" verify coarse.yaml --solver "$manifest" --knob 126 --output out >stdout 2>stderr
  check "$solver on 125 elements: $(cat stdout stderr)" test $? -eq 0
}

# A jump over unstable stretches of the branch ends at a state of rest.
passes_over_jumps() {
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
  "$program" verify jumps.yaml --solver "$manifest" --knob 251 --output out >stdout 2>stderr
  check "$solver passes over the jumps: $(cat stdout stderr)" test $? -eq 0
}

case $solver in
newton | triangles)
  conforms 126
  solves_smoke 501
  passes_spurious_folds
  ;;
copson)
  conforms 1
  solves_smoke 1
  ;;
relax)
  conforms 126
  passes_over_jumps
  ;;
paper)
  command -v octave-cli >/dev/null || exit 77
  conforms 251
  ;;
wrong)
  expect 1 '' conform "$manifest" --knob four_thirds --output out
  check 'the mistake is named' grep -q '^wrong *force at pull-off: the expected value times 4/3 in 4 scenes' stdout
  ;;
*)
  check "a solver that this test knows: $solver" false
  ;;
esac
finish
