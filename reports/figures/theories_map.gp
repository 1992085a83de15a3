# The nearest theory of wavy spheres: (a) usual preload, (b) any. Data: usual.dat, any.dat: a block of cells (in logarithms) for
# each kind of theory and each of three levels, then one for none.
set multiplot
unset grid
array files[2] = ['usual.dat', 'any.dat']
array left[2] = [0.085, 0.4]; array right[2] = [0.365, 0.68]
array heading[2] = ['(a) preload π{/:Italic wR}', '(b) any preload']
set xrange [x_low:x_high]; set yrange [y_low:y_high]
set tmargin at screen 0.92; set bmargin at screen 0.155
set xlabel 'Tabor parameter μ' offset 0,0.3
set style fill solid noborder
set xtics (); set ytics ()
do for [k = -3:1] {
  do for [d = 1:9] {
    t = d * 10.0**k
    if (d == 1 || d == 2 || d == 5) {
      set ytics add (sprintf('%g', t) log(t)); set xtics add (sprintf('%g', t) log(t))
    } else { set ytics add ('' log(t) 1); set xtics add ('' log(t) 1) }
  }
}
set tics front
array levels[3] = ['within 1 %', '5 %', '20 %']
do for [m = 1:2] {
  set lmargin at screen left[m]; set rmargin at screen right[m]
  if (m == 1) { set ylabel y_label offset 1.2,0 } else {
    unset ylabel; set ytics ()
    do for [k = -3:1] { do for [d = 1:9] { set ytics add ('' log(d * 10.0**k) 1) } }
  }
  set label 1 heading[m] at graph 0.5, graph 1.05 center
  unset key
  plot for [k = 1:13] files[m] index k-1 using 1:2:3:4:5:6 with boxxyerror linecolor rgb colours[k]
}
# the key: three shades for each kind
unset xtics; unset ytics; unset border; unset xlabel; unset ylabel; unset label 1
set lmargin at screen 0; set rmargin at screen 1; set tmargin at screen 1; set bmargin at screen 0
set xrange [0:1]; set yrange [0:1]
do for [k = 1:4] {
  do for [l = 1:3] {
    set object 10 * k + l rectangle from 0.70 + 0.024 * (l - 1), 0.86 - 0.17 * (k - 1) to 0.72 + 0.024 * (l - 1), 0.9 - 0.17 * (k - 1) \
      fillcolor rgb colours[3 * (k - 1) + l] fillstyle solid noborder
  }
  set label 10 + k kinds[k] at 0.70, 0.825 - 0.17 * (k - 1) left
}
set object 60 rectangle from 0.70, 0.18 to 0.72, 0.22 fillcolor rgb colours[13] fillstyle solid noborder
set label 20 'none within 20 %' at 0.73, 0.2 left
plot -1 notitle
unset multiplot
