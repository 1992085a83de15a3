# Force of wavy over that of smooth viscoelastic spheres against the speed; a panel for each preload and material. Data:
# enhancement.dat, a block for each panel and each A/lambda, the latter fastest.
set multiplot
set logscale x
set xrange [x_low:x_high]; set yrange [0:greatest]
set format x '10^{%L}'
array left[2] = [0.075, 0.545]; array right[2] = [0.515, 0.985]
array top[2] = [0.985, 0.525]; array bottom[2] = [0.565, 0.105]
do for [p = 1:|panel_text|] {
  c = (p - 1) % 2 + 1; r = (p - 1) / 2 + 1
  set lmargin at screen left[c]; set rmargin at screen right[c]
  set tmargin at screen top[r]; set bmargin at screen bottom[r]
  set xtics 100
  set format x (r == 2 ? '10^{%L}' : '')
  if (r == 2) { set xtics add ('0' rest, '∞' once); set xlabel 'speed, ε/τ_0' offset 0,0.3 } else { set xtics add ('' rest, '' once) }
  set format y (c == 1 ? '%g' : '')
  set ylabel (c == 1 ? 'force over that of the smooth sphere' : '') offset 1,0
  set label 1 panel_text[p] at graph 0.03, graph 0.05 left
  if (p == 1) { set key at graph 0.985, graph 0.97 right top Right noreverse } else { set key off }
  plot 1 with lines linewidth 0.8 dashtype 3 linecolor rgb grey notitle, \
       for [i = 1:ratio_count] 'enhancement.dat' index (p - 1) * ratio_count + i - 1 using 1:2 with linespoints pointtype 7 \
         pointsize 0.45 linewidth 1.1 linecolor rgb colour[i] title ratio_text[i]
}
unset multiplot
