# Figure 10: pull-off force against A/lambda, a panel a wavelength; below, the relative difference of
# the paper's discretisation. Data: computed.dat, missing.dat, guduru.dat, difference.dat, each a block
# a pair of wavelength and radius, radii fastest.

set multiplot
set logscale xy
set xrange [0.00085:1.18]
array left[2] = [0.075, 0.555]; array right[2] = [0.505, 0.985]
array top[2] = [0.985, 0.655]; array bottom[2] = [0.675, 0.345]
do for [p = 1:panel_count] {
  c = (p - 1) % 2 + 1; r = (p - 1) / 2 + 1
  set lmargin at screen left[c]; set rmargin at screen right[c]
  set tmargin at screen top[r]; set bmargin at screen bottom[r]
  set yrange [floor:30]
  set xtics 10; set mxtics 10; set mytics 10
  set format x (r == 2 ? '10^{%L}' : ''); set format y (c == 1 ? '%g' : '')
  set ylabel (c == 1 ? '|{/:Italic W̄}| at pull-off' : '') offset 1,0
  set xlabel (r == 2 ? 'A/λ' : '') offset 0,0.7
  set label 1 panel_text[p] at graph 0.04, graph 0.93 left
  if (p == 1) { set key at graph 0.04, graph 0.05 left bottom Left reverse } else { set key off }
  b = (p - 1) * radius_count
  plot for [i = 1:radius_count] 'guduru.dat' index b+i-1 using 1:2 with lines linewidth 1.1 \
         dashtype 2 linecolor rgb colour[i] notitle, \
       NaN with lines linewidth 1.1 dashtype 2 linecolor rgb black title 'JKR, Eq 5', \
       for [i = 1:radius_count] 'computed.dat' index b+i-1 using 1:2 with linespoints \
         pointtype shape[i] pointsize 0.55 linewidth 0.9 dashtype 4 linecolor rgb colour[i] \
         title radius_text[i], \
       for [i = 1:(missing ? radius_count : 0)] 'missing.dat' index b+i-1 using 1:2 with points \
         pointtype 2 pointsize 0.8 linewidth 1.3 linecolor rgb colour[i] notitle
}
unset label
set lmargin at screen left[1]; set rmargin at screen right[2]
set tmargin at screen 0.265; set bmargin at screen 0.075
set format x '10^{%L}'; set xlabel 'A/λ' offset 0,0.7
set yrange [low:high]; set ytics auto format '10^{%L}'; set ytics 10.0**ceil(log10(high / low) / 4.0)
unset mytics
set ylabel 'relative difference' offset 1,0
set key off
plot for [k = 0:panel_count*radius_count-1] 'difference.dat' index k using 1:2 with points \
       pointtype shape[k % radius_count + 1] pointsize 0.4+0.15*(k/radius_count) linewidth 1.1 \
       linecolor rgb colour[k % radius_count + 1] notitle
unset multiplot
