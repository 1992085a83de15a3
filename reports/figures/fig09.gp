# Figure 9: gap and traction against the radius at pull-off.
# Data: gap.dat, traction.dat (a block for each scene).

set multiplot
set lmargin at screen 0.085; set rmargin at screen 0.985
set xrange [r_min:r_max]

set tmargin at screen 0.985; set bmargin at screen 0.56
set yrange [gap_min:gap_max]
set xtics 10 format ''; set ytics 5 format '%g'
set ylabel '{/:Italic H}' rotate by 0 offset 1.5,0
set key off
set label 1 '(a)' at graph 0.015, graph 0.93
plot for [i = 1:count] 'gap.dat' index i-1 using 1:2 with lines \
       linecolor rgb colour[i] dashtype dash[i] linewidth 1.5 notitle

set tmargin at screen 0.53; set bmargin at screen 0.105
set yrange [traction_min:traction_max]
set xtics 10 format '%g'; set ytics auto format '%g'
set xlabel 'r/ε' offset 0,0.4
set ylabel '{/:Italic P}' rotate by 0 offset 1.5,0
set key at graph 0.985, graph 0.96 right top Left reverse
set label 1 '(b)'
plot for [i = 1:count] 'traction.dat' index i-1 using 1:2 with lines \
       linecolor rgb colour[i] dashtype dash[i] linewidth 1.5 title label[i]
unset multiplot
