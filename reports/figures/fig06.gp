# Figure 6: load against minus the approach of rigid wavy spheres; below, the distance from Eq 22.
# Data: rigid.dat and computed.dat (a block for each value of alpha), residual.dat (panels, the paper's).

set multiplot
set lmargin at screen 0.088; set rmargin at screen 0.985
set tmargin at screen 0.985; set bmargin at screen 0.365
set xrange [x_min:x_max]; set yrange [y_min:y_max]
set xtics 0.5 format ''; set ytics 0.5 format '%.1f'
set ylabel '{/:Italic W̄}' rotate by 0 offset 1.5,0
set key at graph 0.985, graph 0.05 right bottom Left reverse
do for [i = 1:label_count] {
  set label i label_text[i] at name_x[i], name_y[i] center front
  if (abs(name_x[i] - label_x[i]) > 0.01) {
    set arrow i from first name_x[i] + 0.2 * (label_x[i] - name_x[i]), first name_y[i] + 0.2 * (label_y[i] - name_y[i]) \
      to label_x[i], label_y[i] nohead linewidth 0.6 linecolor rgb grey front
  }
}
set label 99 'numbers: log_{10} α' at graph 0.985, graph 0.955 right
set label 98 '(a)' at graph 0.07, graph 0.94 left
plot for [i = 1:line_count] 'rigid.dat' index i-1 using 1:2 with lines \
       linecolor rgb black linewidth 1.2 title (i == 1 ? 'Eq 22' : ''), \
     for [i = 1:mark_count] 'computed.dat' index i-1 using 1:2 with points \
       pointtype 4 pointsize 0.7 linewidth 1.2 linecolor rgb blue \
       title (i == 1 ? 'BEM, μ = 10^{−4}' : ''), \
     'links.dat' index 0 @link

unset label
unset arrow
set label 98 '(b)' at graph 0.012, graph 0.86 left
set tmargin at screen 0.335; set bmargin at screen 0.105
set xtics 0.5 format '%g'
set xlabel '−Δ†' offset 0,0.4
set logscale y
set yrange [low:high]; unset mytics; set ytics auto format '10^{%L}'; set ytics 10.0**ceil(log10(high / low) / 4.0)
set ylabel 'absolute distance' rotate by 90 offset 0.5,0
set key horizontal at graph 0.985, graph 0.95 right top Left reverse
set arrow 9 from graph 0, first cut to graph 1, first cut nohead dashtype 2 linewidth 0.9 linecolor rgb black
plot 'residual.dat' index 0 using 1:2 with points pointtype 7 pointsize 0.25 linecolor rgb blue \
       title 'panels, unbounded', \
     'residual.dat' index 1 using 1:2 with points pointtype 6 pointsize 0.3 linecolor rgb vermillion \
       title 'paper’s, cut at r = R'
unset multiplot
