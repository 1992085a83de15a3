# Figure 2: (a) traction against gap, law.dat; (b) surfaces.dat: radius, indenter, half-space, then
# both in the deformed state.

set multiplot
set lmargin at screen 0.115; set rmargin at screen 0.44
set tmargin at screen 0.97; set bmargin at screen 0.17
set xrange [0.9:3]; set yrange [-1.25:1.25]
set xtics 0.5 format '%g'; set ytics 0.5 format '%.1f'
set xlabel '{/:Italic h}/ε' offset 0,0.3; set ylabel 'σε/{/:Italic w}' offset 1,0
set arrow 1 from 0.9,0 to 3,0 nohead linewidth 0.7 linecolor rgb grey
set label 1 '(a)' at graph 0.97, graph 0.94 right
set key off
plot 'law.dat' using 1:2 with lines linewidth 1.5 linecolor rgb blue notitle

unset arrow
set lmargin at screen 0.53; set rmargin at screen 0.985
set xrange [-reach:reach]; set yrange [-2:8]
set xtics 10; set ytics 2 format '%g'
set xlabel '{/:Italic r}/ε'; set ylabel 'height/ε' offset 0.5,0
# The nodes are sparse where the surfaces are smooth, so a spline is drawn through them.
set samples 800
set label 1 '(b)' at graph 0.5, graph 0.94 center
plot for [k = 2:3] 'surfaces.dat' using 1:k smooth csplines with lines linewidth 1.6 linecolor rgb '#B0B0B0' notitle, \
     for [k = 4:5] 'surfaces.dat' using 1:k smooth csplines with lines linewidth 1.3 linecolor rgb black notitle
unset multiplot
