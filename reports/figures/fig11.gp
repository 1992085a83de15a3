# Figure 11: effective work of adhesion against the Johnson parameter, one frame for each wavelength. Data: computed.dat (a block
# for each pair of wavelength and radius, radii fastest), clear.dat (the same, for markers clearly below Eq 30), harder.dat (the
# same, at any preload), envelope.dat (Eq 24), tosatti.dat (Eq 30).

set multiplot
set logscale xy
set xrange [0.03:250]
set xtics 10; set mxtics 10; set ytics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10)
array left[2] = [0.075, 0.56]; array right[2] = [0.505, 0.985]
array top[2] = [0.98, 0.535]; array bottom[2] = [0.565, 0.12]
do for [p = 1:wavelength_count] {
  c = (p - 1) % 2 + 1; r = (p - 1) / 2 + 1
  set lmargin at screen left[c]; set rmargin at screen right[c]
  set tmargin at screen top[r]; set bmargin at screen bottom[r]
  set yrange [floors[p]:12]
  set format x (r == 2 ? '%g' : ''); set format y '%g'
  set xlabel (r == 2 ? 'Johnson parameter α_{KLJ}' : '') offset 0,0.3
  set ylabel (c == 1 ? '{/:Italic w}_{eff}/{/:Italic w}' : '') offset 1,0
  set label 1 wavelength_text[p] at graph 0.965, graph 0.92 right
  if (p <= 2) { set key at graph 0.985, graph 0.03 right bottom Left reverse } else { set key off }
  b = (p - 1) * radius_count
  plot 'envelope.dat' using 1:2 with lines linewidth 1.4 linecolor rgb black title (p == 1 ? 'Eq 24, Kesari–Lew' : ''), \
       'tosatti.dat' using 1:2 with lines linewidth 1.4 dashtype 4 linecolor rgb black title (p == 1 ? 'Eq 30, Persson–Tosatti' : ''), \
       for [i = 1:radius_count] NaN with points pointtype 7 pointsize 0.6 linecolor rgb colour[i] title (p == 2 ? radius_text[i] : ''), \
       for [i = 1:radius_count] 'computed.dat' index b+i-1 using 1:2 with linespoints pointtype shape[p] pointsize 0.5 \
         linewidth 0.6 dashtype 3 linecolor rgb colour[i] notitle, \
       for [i = 1:radius_count] 'clear.dat' index b+i-1 using 1:2 with points pointtype shape[p] + 1 pointsize 0.6 \
         linecolor rgb colour[i] notitle, \
       for [i = 1:radius_count] 'harder.dat' index b+i-1 using 1:2 with points pointtype 2 pointsize 0.6 linewidth 1.2 \
         linecolor rgb colour[i] notitle
}
unset multiplot
