# Pull-off force of viscoelastic smooth spheres against the speed; a panel for each material. Data: force.dat, a block for each
# panel and each Tabor parameter, the latter fastest; theory.dat: the same of Persson and Brener.
set multiplot
set logscale xy
set xrange [x_low:x_high]; set yrange [1.2:30]
set xtics 100; set format x '10^{%L}'; set xtics add ('0' rest, '∞' once)
set ytics (1.5, 2, 3, 5, 10, 15, 20)
set xlabel 'speed, ε/τ_0' offset 0,0.3
array left[2] = [0.075, 0.545]; array right[2] = [0.515, 0.985]
set tmargin at screen 0.97; set bmargin at screen 0.155
do for [p = 1:|panel_text|] {
  set lmargin at screen left[p]; set rmargin at screen right[p]
  set format y (p == 1 ? '%g' : '')
  set ylabel (p == 1 ? 'pull-off force, π{/:Italic wR}' : '') offset 1,0
  set label 1 panel_text[p] at graph 0.97, graph 0.94 right
  if (p == 1) { set key at graph 0.03, graph 0.76 left top Left reverse } else { set key off }
  plot for [y in '1.5 15 20'] real(y) with lines linewidth 0.8 dashtype 3 linecolor rgb grey notitle, \
       for [i = 1:tabor_count] 'theory.dat' index (p - 1) * tabor_count + i - 1 using 1:2 with lines dashtype 2 linewidth 1.1 \
         linecolor rgb colour[i] notitle, \
       for [i = 1:tabor_count] 'force.dat' index (p - 1) * tabor_count + i - 1 using 1:2 with linespoints pointtype 7 \
         pointsize 0.4 linewidth 1.1 linecolor rgb colour[i] title tabor_text[i]
}
unset multiplot
