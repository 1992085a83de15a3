#!/bin/sh
# An external solver, here the NumPy program of reference/solvers, is judged by the case of Figure 4 with two meshes: the
# difference of each pull-off force from the reference, divided by the tolerance. Usage: judged.sh FIGURE
solver=$(dirname "$0")/../../reference/solvers/newton.yaml
for nodes in 126 251; do
  pulloff verify fig04_paper --solver "$solver" --knob $nodes --points 0-14 --verbose >$nodes.txt
  sed -n 's/^newton.* pull_off_force *tabor=//p' $nodes.txt >$nodes.dat
  tail -n 1 $nodes.txt
done
gnuplot <<END
set terminal pngcairo size 540,310 font ",10"
set output "$1"
set logscale x
set xlabel "Tabor parameter"
set ylabel "|error| / tolerance"
set yrange [0:1.4]
plot for [nodes in "126 251"] nodes.".dat" using 1:4 with linespoints pointtype 7 pointsize 0.6 title nodes." nodes", 1 dashtype 2 title "passes"
END
