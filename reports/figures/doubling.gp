# The preload that gives twice the pull-off force, over the Tabor parameter and A/lambda: (a) displacement control,
# (b) load control. Data: displacement_control.dat, load_control.dat: a block of cells (in logarithms) for each class of preloads.

set multiplot
unset grid
array files[2] = ['displacement_control.dat', 'load_control.dat']
array left[2] = [0.085, 0.575]; array right[2] = [0.345, 0.835]
array heading[2] = ['(a) Δ†', '(b) {/:Italic W̄}']
set xrange [x_low:x_high]; set yrange [y_low:y_high]
set tmargin at screen 0.92; set bmargin at screen 0.155
set xlabel 'Tabor parameter μ' offset 0,0.3
set style fill solid noborder
set xtics (); set ytics ()
do for [k = -3:0] {
  do for [d = 1:9] {
    t = d * 10.0**k
    if (d == 1) { set ytics add (sprintf('10^{%d}', k) log(t)) } else { set ytics add ('' log(t) 1) }
    if (d == 1 || d == 2 || d == 5) { set xtics add (sprintf('%g', t) log(t)) } else { set xtics add ('' log(t) 1) }
  }
}
set tics front
do for [m = 1:2] {
  set lmargin at screen left[m]; set rmargin at screen right[m]
  if (m == 1) { set ylabel '{/:Italic A}/λ' offset 1.2,0 } else { unset ylabel }
  set label 1 heading[m] at graph 0.5, graph 1.05 center
  set key at screen right[m] + 0.012, screen 0.9 left top Left reverse samplen 1.2 width -2
  plot for [k = 1:class_count] files[m] index k-1 using 1:2:3:4:5:6 with boxxyerror linecolor rgb colours[k] \
         title (m == 1 ? approach_text[k] : load_text[k])
}
unset multiplot
