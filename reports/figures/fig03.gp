# Figure 3: load against minus the approach; below, the distance of the reference from the branch.
# Data: computed.dat (a block a Tabor parameter), reference.dat, rigid.dat, published.dat, residual.dat
# and ripple.dat (each by panels, as in the paper).

# Heights on the screen: all is moved up where there is room for the ripple below.
below = ripple ? 0.22 : 0
high(y) = below + (1 - below) * y
left = 0.098; right = 0.985
set multiplot

# The loading curves.
set lmargin at screen left; set rmargin at screen right
set tmargin at screen high(0.985); set bmargin at screen high(0.365)
set xrange [x_min:x_max]; set yrange [y_min:y_max]
set xtics 1 format ''; set mxtics 2; set ytics 0.5 format '%.1f'
set ylabel '{/:Italic W̄}' rotate by 0 offset 1.5,0
set key at graph 0.985, graph 0.955 right top Left reverse
do for [i = 1:label_count] {
  set label i label_text[i] at label_x[i], label_y[i] center offset 0,-1.05 textcolor rgb label_colour[i]
}
plot for [i = 1:curve_count] 'computed.dat' index i-1 using 1:2 with lines \
       linecolor rgb black linewidth 1.3 title (i == 1 ? 'computed' : ''), \
     for [i = 1:mark_count] 'reference.dat' index i-1 using 1:2 with points \
       pointtype mark_shape[i] pointsize 0.7 linewidth 1.25 linecolor rgb mark_colour[i] \
       title (i == 1 ? 'reference, Feng’s problem' : ''), \
     for [i = 1:(cross_count > 0)] 'published.dat' using 1:2 with points \
       pointtype 1 pointsize 0.8 linewidth 1.25 linecolor rgb black title 'Feng, read off his figure', \
     for [i = 1:(dot_count > 0)] 'rigid.dat' using 1:2 with points \
       pointtype 7 pointsize 0.5 linecolor rgb vermillion title 'Bradley, rigid'

unset label

# The residual strip.
set tmargin at screen high(0.335); set bmargin at screen high(0.105)
set xtics 1 format '%g'; set mxtics 2
set xlabel '−Δ†' offset 0,0.4
set logscale y
set yrange [low:high]; set ytics auto format '10^{%L}'; unset mytics
decades = log10(high / low)
set ytics 10.0**ceil(decades / 4.0)
set ylabel 'distance' rotate by 90 offset 0.5,0
set key horizontal at graph 0.985, graph 0.95 right top Left reverse
plot for [i = 1:(panel_count > 0)] 'residual.dat' index 0 using 1:2 with points \
       pointtype 7 pointsize 0.25 linecolor rgb blue title 'panels, unbounded', \
     for [i = 1:(paper_count > 0)] 'residual.dat' index 1 using 1:2 with points \
       pointtype 6 pointsize 0.3 linecolor rgb vermillion title 'as in the paper', \
     for [i = 1:(panel_count + paper_count == 0)] 1/0 notitle

# The pull-off of a soft sphere.
if (ripple) {
  set tmargin at screen 0.195; set bmargin at screen 0.085
  unset logscale y
  set xrange [*:*] noextend; set yrange [*:*]
  set xtics 0.2 format '%.1f'; set ytics 0.004 format '%.3f'
  set ylabel '{/:Italic W̄}' rotate by 0 offset 1.5,0
  set label 1 ripple_text at graph 0.5, graph 0.84 center
  set key off
  plot 'ripple.dat' index 1 using 1:2 with lines linecolor rgb vermillion linewidth 1, \
       'ripple.dat' index 0 using 1:2 with lines linecolor rgb black linewidth 1.3
}
unset multiplot
