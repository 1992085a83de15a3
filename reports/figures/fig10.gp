# Figure 10: pull-off force against A/lambda: one frame for each wavelength, then all in one frame as in the paper; at the
# bottom, the relative difference from the paper's discretisation. Data: computed.dat, harder.dat (at any preload),
# missing.dat, guduru.dat, difference.dat, each with a block for each pair of wavelength and radius, radii fastest.

set multiplot
set logscale xy
set xrange [0.00085:1.18]
set xtics 10; set mxtics 10; set ytics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20)
groups = panel_count * radius_count

array left[2] = [0.075, 0.56]; array right[2] = [0.505, 0.985]
array top[2] = [0.988, 0.72]; array bottom[2] = [0.745, 0.477]
do for [p = 1:panel_count] {
  c = (p - 1) % 2 + 1; r = (p - 1) / 2 + 1
  set lmargin at screen left[c]; set rmargin at screen right[c]
  set tmargin at screen top[r]; set bmargin at screen bottom[r]
  set yrange [floors[p]:25]
  set format x (r == 2 ? '10^{%L}' : ''); set format y '%g'
  set ylabel (c == 1 ? '|{/:Italic W̄}| at pull-off' : '') offset 1,0
  set label 1 (p == 1 ? '(a) ' : '') . panel_text[p] at graph 0.04, graph 0.92 left
  if (p == 1) { set key at graph 0.02, graph 0.04 left bottom Left reverse maxrows 2 } else { set key off }
  b = (p - 1) * radius_count
  plot for [i = 1:radius_count] NaN with points pointtype 7 pointsize 0.6 linecolor rgb colour[i] title radius_text[i], \
       NaN with lines linewidth 1.1 dashtype 2 linecolor rgb black title 'JKR, Eq 5', \
       for [i = 1:radius_count] 'guduru.dat' index b+i-1 using 1:2 with lines linewidth 1.1 \
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

# all spheres, as in the paper: the shape of a marker shows the wavelength, its colour the radius
set lmargin at screen 0.075; set rmargin at screen 0.985
set tmargin at screen 0.435; set bmargin at screen 0.185
set format x ''; set format y '%g'
set ylabel '|{/:Italic W̄}| at pull-off' offset 1,0
set label 1 '(b)' at graph 0.02, graph 0.08 left
set yrange [floor:25]
set key at graph 0.1, graph 0.05 left bottom Left reverse maxrows 2
plot for [i = 1:panel_count] NaN with points pointtype form[i] pointsize 0.7 linewidth 1.1 linecolor rgb black \
       title panel_text[i], \
     for [k = 0:groups-1] 'guduru.dat' index k using 1:2 with lines linewidth 0.9 \
       dashtype 2 linecolor rgb colour[k % radius_count + 1] notitle, \
     for [k = 0:groups-1] 'computed.dat' index k using 1:2 with linespoints pointtype form[k / radius_count + 1] \
       pointsize 0.5 linewidth 0.6 dashtype 4 linecolor rgb colour[k % radius_count + 1] notitle, \
     'links.dat' index 0 @link

unset label
set tmargin at screen 0.165; set bmargin at screen 0.055
set format x '10^{%L}'; set xlabel 'A/λ' offset 0,0.7
set yrange [low:high]; unset ytics; set ytics 10 nomirror in; set format y '10^{%L}'; set ytics 10.0**ceil(log10(high / low) / 4.0)
unset mytics
set ylabel 'rel. difference' offset 1,0
set label 1 '(c)' at graph 0.02, graph 0.85 left
set key off
plot for [k = 0:groups-1] 'difference.dat' index k using 1:2 with points \
       pointtype form[k / radius_count + 1] pointsize 0.6 linewidth 1.1 \
       linecolor rgb colour[k % radius_count + 1] notitle
unset multiplot
