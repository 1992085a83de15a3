# Pull-off force of several profiles relative to the JKR theory (a), and its distance from 1 (b).
# Data: ratio.dat and away.dat, each with a block for each profile.

set multiplot
set logscale xy
set xlabel '√(2π{/:Italic wa}/{/:Italic E}*) / (3.094 ε)' offset 0,0.3
set tmargin at screen 0.97; set bmargin at screen 0.155
array panel_data[2] = ['ratio.dat', 'away.dat']
array panel_label[2] = ['pull-off force / JKR', '| pull-off force / JKR − 1 |']
array panel_mark[2] = ['(a)', '(b)']
do for [p = 1:2] {
  set lmargin at screen (p == 1 ? 0.085 : 0.61); set rmargin at screen (p == 1 ? 0.5 : 0.985)
  set format x '%g'; set format y (p == 1 ? '%g' : '10^{%L}')
  if (p == 1) { set xrange [0.03:80]; set yrange [0.15:40]; set ytics (0.2, 0.5, 1, 2, 5, 10, 20); set mytics 1 } else {
    set xrange [0.5:80]; set yrange [1e-4:5]; set ytics auto; set ytics 10; unset mytics }
  set ylabel panel_label[p] offset 1,0
  set label 1 panel_mark[p] at graph 0.03, graph 0.94 left
  set key off
  if (p == 1) { set key at graph 0.98, graph 0.97 right top Right noreverse
    set arrow 1 from graph 0, first 1 to graph 1, first 1 nohead dashtype 3 linewidth 1.2 linecolor rgb grey } else { unset arrow 1 }
  plot for [k = 1:count] panel_data[p] index k-1 using 1:2 with linespoints pointtype shape[k] pointsize 0.6 linewidth 1.1 \
         linecolor rgb colour[k] title name[k]
}
unset multiplot
