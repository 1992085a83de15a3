#!/bin/sh
# The C program threads.c: compiled with the installed library, run, and its table drawn. Usage: c_program.sh FIGURE
set -e
# The words of pkg-config are options.
# shellcheck disable=SC2046
cc "$(dirname "$0")/threads.c" $(pkg-config --cflags --libs pulloff) -pthread -o threads
./threads | tee forces.txt
gnuplot <<END
set terminal pngcairo size 540,310 font ",10"
set output "$1"
set yrange [1.4:2]
set xlabel "Tabor parameter"
set ylabel "pull-off force / πwR"
plot "forces.txt" using 1:2 with linespoints pointtype 7 title "threads.c", "" using 1:4 with lines dashtype 2 title "JKR"
END
