# The pull-off forces of a run against one key of its sweep, a curve for each combination of the others.
# Data blocks: curve1, curve2, ...; name1, name2, ... are their names.

set lmargin at screen 0.085; set rmargin at screen (curve_count > 1 ? 0.76 : 0.98)
set tmargin at screen 0.92; set bmargin at screen 0.13
set label 1 caption at screen 0.015, screen 0.965 left noenhanced font ',8' textcolor rgb grey
set xlabel key_name noenhanced offset 0,0.4
set ylabel 'pull-off force/'.load_unit offset 1,0
if (is_log) { set logscale x; set xtics format '%g' }
set offsets 0, 0, graph 0.05, graph 0.05
if (curve_count > 1) { set key outside right top Left reverse noenhanced font ',8' } else { set key off }
set palette defined (0 '#0072B2', 0.35 '#009E73', 0.7 '#E69F00', 1 '#D55E00')
unset colorbox
plot for [i = 1:curve_count] '$curve'.i using 1:2:3 with yerrorbars pointtype 7 pointsize 0.3 linewidth 0.8 \
       linecolor palette frac (curve_count > 1 ? (i - 1.0) / (curve_count - 1) : 0) notitle, \
     for [i = 1:curve_count] '$curve'.i using 1:2 with lines linewidth 1.4 \
       linecolor palette frac (curve_count > 1 ? (i - 1.0) / (curve_count - 1) : 0) title value('name'.i)
unset output
