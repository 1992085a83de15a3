#!/bin/sh
# Wrong usage: the message is one line that names the mistake, and the exit code is 2. The help of every verb has an
# example.
# shellcheck disable=SC1091,SC2034,SC2154
. "$(dirname "$0")/lib.sh"

expect 2 'pulloff: no verb is given: expected solve, compare, follow, theory, contact-law, profile, fit, plot, list, plan, run, merge, verify, explain, *'
expect 2 'pulloff: unknown verb dance: expected solve, compare, follow, theory, contact-law, profile, fit, plot, list, *' dance
expect 0 '' --version
expect 0 '' --help
cp "$work/stdout" "$work/help"
expect 0 '' -h
check '-h prints the same help' cmp -s "$work/stdout" "$work/help"
for verb in solve compare follow theory contact-law profile fit plot list plan run merge verify explain bless conform seal report; do
  expect 0 '' "$verb" -h
  cp "$work/stdout" "$work/help"
  expect 0 '' "$verb" --help
  check "the same help of $verb by -h" cmp -s "$work/stdout" "$work/help"
  check "no line of the help of $verb is longer than 100 characters" [ -z "$(grep -E '.{101}' "$work/stdout")" ]
  check "help of $verb has an example" grep -q "^Example: pulloff $verb" "$work/stdout"
  expect 2 "pulloff: unknown option --frobnicate of $verb (see pulloff $verb --help)" \
    "$verb" --frobnicate
  expect 2 "pulloff: --help=3 of $verb has a value: expected --help without one (see pulloff $verb --help)" \
    "$verb" word --help=3
  expect 0 '' "$verb" word -h
  check "help of $verb after an operand" cmp -s "$work/stdout" "$work/help"
done
# Operands before options, letters with a value attached, values of options that take none, and beginnings of several options:
# "run smoke -j2" ended with "unknown option smoke".
expect 2 'pulloff: unknown option --frobnicate=3 of run (see pulloff run --help)' run word other --frobnicate=3
for given in '-q' '-q2' 'word -q2' 'word -q 2' '-q2 word' 'word other -qx'; do
  # shellcheck disable=SC2086
  expect 2 'pulloff: unknown option -q of run (see pulloff run --help)' run $given
done
for verb in run verify explain bless; do
  for given in '-jx word' '-j x word' 'word -jx' 'word --jobs=x' 'word --job x'; do
    # shellcheck disable=SC2086
    expect 2 'pulloff: --jobs is x: expected a whole number, 0 for all cores' "$verb" $given
  done
  expect 2 "pulloff: the option -j of $verb needs a value (see pulloff $verb --help)" "$verb" word -j
  [ "$verb" = bless ] || expect 2 'pulloff: no case is named word: *' "$verb" word -j2
done
expect 2 'pulloff: unknown option -j of list (see pulloff list --help)' list word -j2
expect 2 'pulloff: --out of solve is the beginning of several options: expected one of --outer-radius, --outer-radius-m*' \
  solve --out 3

# A word that is close to a known one: the message ends with the known one.
for slip in 'slove;solve' 'solve --amplitud 3;--amplitude' 'solve --outer_radius 3;--outer-radius' 'solve --pre 3;--preload' \
  'solve --want curve,histeresis;hysteresis' 'solve --law morze:2;morse' 'solve --scheme pannel;panel' 'theory jrk;jkr' \
  'theory DMT;dmt' 'compare --theory mauguis;maugis' 'run fig4;fig04' 'run --suite papr;paper' 'follow --key tabr;tabor'; do
  # shellcheck disable=SC2086
  expect 2 "pulloff: *; did you mean ${slip#*;}[?]" ${slip%;*}
done
expect 2 'pulloff: --tabor is abc: expected a finite number >= 0' solve --tabor abc
expect 2 'pulloff: --tabor is nan: expected a finite number >= 0' solve --tabor nan
expect 2 'pulloff: --tabor is empty: expected a finite number >= 0' solve --tabor ''
expect 2 'pulloff: the option --tabor of solve needs a value (see pulloff solve --help)' \
  solve --tabor
expect 2 'pulloff: --radius is -3: expected a finite number > 0' solve --radius -3
expect 2 'pulloff: --outer-radius is nan: expected a finite number > 0, or inf' \
  solve --outer-radius nan
expect 2 'pulloff: --scheme is square: expected ring, triangle or panel' solve --scheme square
expect 2 'pulloff: --grading is steep: expected uniform or graded' solve --grading steep
expect 2 'pulloff: --nodes is 2.5: expected a whole number > 0' solve --nodes 2.5
expect 2 'pulloff: --nodes is -7: expected a whole number > 0' solve --nodes -7
expect 2 'pulloff: *nodes*expected*' solve --scheme ring --nodes 999999999999
expect 2 'pulloff: --nodes is 101: expected it with the scheme ring or triangle, not panel' solve --nodes 101
expect 2 'pulloff: --grading is graded: expected it with the scheme ring or triangle, not panel' \
  solve --grading graded
expect 2 'pulloff: --tolerance is 1e-5: expected it with the scheme panel, not ring' \
  solve --tolerance 1e-5 --scheme ring
expect 2 'pulloff: --tolerance is 1e-11: expected 1e-10 to 0.01' solve --tolerance 1e-11
expect 2 'pulloff: --nodes is 2501: expected 8 to 2500' solve --scheme triangle --nodes 2501
expect 2 'pulloff: --want is sugar: expected any of curve, profile, hysteresis*' solve --want sugar
expect 2 'pulloff: --want is curve,: expected any of curve, profile, hysteresis*' solve --want curve,
expect 2 'pulloff: --wavelength is missing: expected it beside --amplitude' solve --amplitude 1
expect 2 'pulloff: *--approach-end*' solve --approach-start 1 --approach-end 0
expect 2 'pulloff: unexpected argument leftover of solve (see pulloff solve --help)' solve --tabor 0 leftover
expect 2 'pulloff: plan needs the name of a case*' plan
expect 2 'pulloff: --jobs is -1: expected a whole number, 0 for all cores' run --jobs -1
expect 2 'pulloff: --jobs is many: expected a whole number, 0 for all cores' run --jobs many
expect 2 'pulloff: --points is 5-3: expected A-B or one number, counted from 0, or several with commas' run --points 5-3
expect 2 'pulloff: --points is 5-: expected A-B or one number, counted from 0, or several with commas' run --points 5-
expect 2 'pulloff: --points is few: expected A-B or one number, counted from 0, or several with commas' run --points few
expect 2 'pulloff: --points is 0,*: expected at most 64 of A-B or one number' run --points "$(seq -s , 0 64)"
expect 2 'pulloff: no case is named absent: *' run absent --points "$(seq -s , 0 63)"
expect 2 'pulloff: --points begins at 6: expected less than 6, the number of points of smoke' \
  run smoke --points 6
expect 2 'pulloff: --time-limit is 0: expected a finite number > 0' run --time-limit 0
expect 2 'pulloff: --output is empty: expected the name of a folder' run --output ''
expect 2 'pulloff: no case belongs to the suite dessert: expected one of extreme, general, paper, precision, random, rate, smoke, solvers, theories' \
  run --suite smoke,dessert
expect 2 'pulloff: --suite is empty: expected names of suites' run --suite ''
expect 2 'pulloff: unexpected argument smoke of list*' list smoke
finish
