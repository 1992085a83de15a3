#!/bin/sh
# A traction-separation law of one's own: carries out the example tests/recipes/law.recipe of extending.md in a copy of this
# source tree, which takes a minute, and compares the pull-off force under it with that under other laws of the same w and ε.
# Usage: own_law.sh FIGURE
set -e
[ -d own/recipes/tree/build ] || python3 "$(dirname "$0")/../../tests/recipes/recipes.py" own --only law --keep
for law in lennard-jones mie:4,12 morse:1 exponential:1; do
  own/recipes/tree/build/src/cli/pulloff follow --key tabor --from 0.05 --to 10 --points 30 --law "$law" --curve "$law.csv"
done
gnuplot <<END
set terminal pngcairo size 540,310 font ",10"
set output "$1"
set datafile separator ","
set logscale x
set xlabel "Tabor parameter"
set ylabel "pull-off force / πwR"
plot for [law in "lennard-jones mie:4,12 morse:1 exponential:1"] law.".csv" using "tabor":"force" with lines linewidth 1.5 title law
END
