# Figures 14 and 15: pull-off force over the Tabor parameter and A/lambda, both logarithmic.
# Data, in coordinates relative to the frame: regions.dat, the region where the force is known, then for each level the region above it;
# lines.dat, the contour lines; unknown.dat, scenes whose largest force is not known; left.dat and right.dat: force against height, limit and computed.

set multiplot
unset grid
map_left = 0.225; map_right = 0.69; bottom = 0.125; top = 0.93
set tmargin at screen top; set bmargin at screen bottom
set yrange [0:1]
height(r) = log(r / y_low) / log(y_high / y_low)
width(m) = log(m / x_low) / log(x_high / x_low)

# the map
set lmargin at screen map_left; set rmargin at screen map_right
set xrange [0:1]
set xlabel 'Tabor parameter μ' offset 0,0.3
unset xtics; unset ytics
set xtics (); set ytics ()
do for [k = -3:2] {
  do for [d = 1:9] {
    v = d * 10.0**k
    if (v >= 0.999 * x_low && v <= 1.001 * x_high) {
      if (d == 1 || d == 2 || d == 5) { set xtics add (sprintf('%g', v) width(v)) } else { set xtics add ('' width(v) 1) }
    }
    if (v >= 0.999 * y_low && v <= 1.001 * y_high) {
      if (d == 1) { set ytics add ('' height(v)) } else { set ytics add ('' height(v) 1) }
    }
  }
}
set tics front
set arrow 1 from graph 0, first mark to graph 1, first mark nohead dashtype 2 linewidth 1.2 linecolor rgb black front
# a rectangle under each label: a boxed label would be an SVG filter, which PDF does not support
do for [k = 1:label_count] {
  set object 100 + k rectangle center label_x[k], label_y[k] size character 0.8 * strlen(label_text[k]) + 0.7, \
    character 0.8 fillcolor rgb 'white' fillstyle solid noborder front
  set label k label_text[k] at label_x[k], label_y[k] center front
}
set key off
set label 99 title_text at graph 0.5, graph 1.035 center
plot for [k = 0:level_count] 'regions.dat' index k using 1:2 with filledcurves closed \
       fillcolor rgb colours[k + 1] fillstyle solid noborder notitle, \
     'lines.dat' using 1:2 with lines linewidth 0.8 linecolor rgb black notitle, \
     for [k = 1:(unknown_count > 0)] 'unknown.dat' using 1:2 with points pointtype 7 pointsize 0.25 \
       linecolor rgb black notitle, \
     'links.dat' index 0 @link
unset label 99
unset arrow 1
do for [k = 1:label_count] { unset label k; unset object 100 + k }

# the sides
set label 1 at graph 0.5, graph 1.035 center
set grid xtics ytics
set ytics nomirror
set lmargin at screen 0.08; set rmargin at screen map_left - 0.028
set xrange [0:2.2]; set xtics 1; set mxtics 2; set xlabel '|{/:Italic W̄}|'
set ylabel '{/:Italic A}/λ' offset 1.2,0
do for [k = -3:0] { v = 10.0**k; if (v >= 0.999 * y_low) { set ytics add (sprintf('10^{%d}', k) height(v)) } }
set label 1 'μ → 0, ' . left_tabor
plot 'left.dat' index 0 using 1:2 with lines linewidth 1.2 linecolor rgb black notitle, \
     'left.dat' index 1 using 1:2 with points pointtype 4 pointsize 0.35 linewidth 0.8 linecolor rgb vermillion notitle

set lmargin at screen map_right + 0.03; set rmargin at screen 0.86
unset ylabel
set ytics format ''
do for [k = -3:0] { v = 10.0**k; if (v >= 0.999 * y_low) { set ytics add ('' height(v)) } }
set xrange [0:greatest]; set xtics 2; set mxtics 2
set label 1 'μ = ' . right_tabor . ', JKR'
plot 'right.dat' index 0 using 1:2 with lines linewidth 1.2 linecolor rgb black notitle, \
     'right.dat' index 1 using 1:2 with points pointtype 4 pointsize 0.35 linewidth 0.8 linecolor rgb vermillion notitle

# the bar
unset grid; unset xtics; unset xlabel; unset label 1
set lmargin at screen 0.905; set rmargin at screen 0.93
set xrange [0:1]
unset ytics
set y2range [0:1]
set y2tics () out scale 0
set label 1 '|{/:Italic W̄}|' at graph 0.5, graph 1.035 center
do for [k = 0:level_count] {
  set object 10 + k rectangle from graph 0, graph k / (level_count + 1.0) to graph 1, graph (k + 1.0) / (level_count + 1.0) \
    fillcolor rgb colours[k + 1] fillstyle solid noborder behind
}
do for [k = 1:level_count] { set y2tics add (levels[k] k / (level_count + 1.0)) }
plot NaN notitle
unset multiplot
