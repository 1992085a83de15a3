# Figure 10: pull-off force against A/lambda: all in one frame as in the paper, then one frame for each wavelength; at the
# bottom, the relative difference from the paper's discretisation. Data: computed.dat, harder.dat (at any preload),
# missing.dat, guduru.dat, difference.dat, each with a block for each pair of wavelength and radius, radii fastest.

set multiplot
set logscale xy
set xrange [0.00085:1.18]; set yrange [floor:30]
set xtics 10; set mxtics 10; set mytics 10
groups = panel_count * radius_count
set ylabel '|{/:Italic W̄}| at pull-off' offset 1,0

# all spheres, as in the paper: the shape of a marker shows the wavelength, its colour the radius
set lmargin at screen 0.075; set rmargin at screen 0.985
set tmargin at screen 0.988; set bmargin at screen 0.62
set format x '10^{%L}'; set format y '%g'
set label 1 '(a)' at graph 0.02, graph 0.94 left
set key at graph 0.02, graph 0.04 left bottom Left reverse maxrows 4
plot for [i = 1:panel_count] NaN with points pointtype form[i] pointsize 0.7 linewidth 1.1 linecolor rgb black \
       title panel_text[i], \
     for [i = 1:radius_count] NaN with points pointtype 7 pointsize 0.6 linecolor rgb colour[i] title radius_text[i], \
     NaN with lines linewidth 1.1 dashtype 2 linecolor rgb black title 'JKR, Eq 5', \
     for [k = 0:groups-1] 'guduru.dat' index k using 1:2 with lines linewidth 0.9 \
       dashtype 2 linecolor rgb colour[k % radius_count + 1] notitle, \
     for [k = 0:groups-1] 'computed.dat' index k using 1:2 with linespoints pointtype form[k / radius_count + 1] \
       pointsize 0.5 linewidth 0.6 dashtype 4 linecolor rgb colour[k % radius_count + 1] notitle, \
     'links.dat' index 0 @link

array left[2] = [0.075, 0.555]; array right[2] = [0.505, 0.985]
array top[2] = [0.555, 0.36]; array bottom[2] = [0.37, 0.175]
do for [p = 1:panel_count] {
  c = (p - 1) % 2 + 1; r = (p - 1) / 2 + 1
  set lmargin at screen left[c]; set rmargin at screen right[c]
  set tmargin at screen top[r]; set bmargin at screen bottom[r]
  set format x ''; set format y (c == 1 ? '%g' : '')
  set ylabel (c == 1 ? '|{/:Italic W̄}|' : '') offset 1,0
  set label 1 panel_text[p] at graph 0.04, graph 0.9 left
  if (p == 1) { set label 2 '(b)' at graph 0.04, graph 0.1 left } else { unset label 2 }
  set key off
  b = (p - 1) * radius_count
  plot for [i = 1:radius_count] 'guduru.dat' index b+i-1 using 1:2 with lines linewidth 1.1 \
         dashtype 2 linecolor rgb colour[i] notitle, \
       for [i = 1:radius_count] 'computed.dat' index b+i-1 using 1:2 with linespoints \
         pointtype form[p] pointsize 0.5 linewidth 0.9 dashtype 4 linecolor rgb colour[i] notitle, \
       for [i = 1:radius_count] 'harder.dat' index b+i-1 using 1:2 with points \
         pointtype form[p] + 1 pointsize 0.6 linecolor rgb colour[i] notitle, \
       for [i = 1:(missing ? radius_count : 0)] 'missing.dat' index b+i-1 using 1:2 with points \
         pointtype 2 pointsize 0.8 linewidth 1.3 linecolor rgb colour[i] notitle, \
       'links.dat' index p @link
}
unset label
set lmargin at screen left[1]; set rmargin at screen right[2]
set tmargin at screen 0.165; set bmargin at screen 0.055
set format x '10^{%L}'; set xlabel 'A/λ' offset 0,0.7
set yrange [low:high]; set ytics auto format '10^{%L}'; set ytics 10.0**ceil(log10(high / low) / 4.0)
unset mytics
set ylabel 'difference' offset 1,0
set label 1 '(c)' at graph 0.02, graph 0.88 left
set key off
plot for [k = 0:groups-1] 'difference.dat' index k using 1:2 with points \
       pointtype form[k / radius_count + 1] pointsize 0.6 linewidth 1.1 \
       linecolor rgb colour[k % radius_count + 1] notitle
unset multiplot
