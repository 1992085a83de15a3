# Figure 3: load against minus the approach; below, the distance of the reference from the branch.
# Data: computed.dat (a block for each Tabor parameter), reference.dat, rigid.dat, published.dat; with one block for
# panels and one for the paper's discretisation: residual.dat and, for a soft sphere, minimum.dat, nose.dat and folds.dat.

# Heights on the screen: everything moves up if the soft sphere is drawn below.
below = soft ? 0.28 : 0
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
set label 98 '(a)' at graph 0.012, graph 0.94 left
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
       pointtype 7 pointsize 0.5 linecolor rgb orange title 'Bradley, rigid', \
     'links.dat' index 0 @link

unset label
set label 98 '(b)' at graph 0.012, graph 0.86 left

# The distance from the reference.
set tmargin at screen high(0.335); set bmargin at screen high(0.105)
set xtics 1 format '%g'; set mxtics 2
set xlabel '−Δ†' offset 0,0.4
set logscale y
set yrange [low:high]; set ytics auto format '10^{%L}'; unset mytics
decades = log10(high / low)
set ytics 10.0**ceil(decades / 4.0)
set ylabel 'absolute distance' rotate by 90 offset 0.5,0
set key horizontal at graph 0.985, graph 0.95 right top Left reverse
if (paper_count) { set arrow 9 from graph 0, first cut to graph 1, first cut nohead dashtype 2 linewidth 0.9 linecolor rgb black }
plot for [i = 1:(panel_count > 0)] 'residual.dat' index 0 using 1:2 with points \
       pointtype 7 pointsize 0.25 linecolor rgb black title 'panels, unbounded', \
     for [i = 1:(paper_count > 0)] 'residual.dat' index 1 using 1:2 with points \
       pointtype 6 pointsize 0.3 linecolor rgb vermillion title 'paper’s, cut at r = R', \
     for [i = 1:(panel_count + paper_count == 0)] 1/0 notitle

unset arrow 9
unset label 98

# A soft sphere: (c) about the pull-off, (d) about the jump out of contact.
if (soft) {
  set tmargin at screen 0.255; set bmargin at screen 0.075
  unset logscale y
  set key off
  set lmargin at screen left; set rmargin at screen 0.5
  set xrange [*:*] noextend; set yrange [*:*]
  set xtics 0.4 format '%.1f'; set ytics 0.004 format '%.3f'
  set ylabel '{/:Italic W̄}' rotate by 0 offset 1.5,0
  set label 1 '(c)' at graph 0.03, graph 0.9 left
  set label 2 soft_text at graph 0.5, graph 0.9 center
  plot 'minimum.dat' index 1 using 1:2 with lines linecolor rgb vermillion linewidth 1, \
       'minimum.dat' index 0 using 1:2 with lines linecolor rgb black linewidth 1.3
  set lmargin at screen 0.575; set rmargin at screen right
  set xrange [*:*] noextend; set yrange [*:*] noextend
  set offsets 0, 0.01, 0.02, 0.02
  set xtics 0.04 format '%.2f'; set ytics 0.1 format '%.1f'
  unset ylabel
  set label 1 '(d)' at graph 0.03, graph 0.5 left; set label 2 at graph 0.5, graph 0.5
  plot 'nose.dat' index 0 using 1:2 with lines linecolor rgb black linewidth 1.3, \
       'nose.dat' index 1 using 1:2 with lines linecolor rgb vermillion linewidth 0.7, \
       'folds.dat' index 1 using 1:2 with points pointtype 7 pointsize 0.3 linecolor rgb vermillion, \
       'folds.dat' index 0 using 1:2 with points pointtype 6 pointsize 0.8 linecolor rgb black, \
       'links.dat' index 1 @link
}
unset multiplot
