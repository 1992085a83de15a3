# Pull-off force of the smooth sphere under several laws (a), and its distance from the rigid (b) and the JKR limit (c).
# Data: force.dat, rigid.dat, jkr.dat, each with a block for each law, then one for the Maugis-Dugdale theory.

set multiplot
set logscale x
decade = '10^{%L}'
set format x decade
set xlabel 'Tabor parameter μ' offset 0,0.3

# (a)
set lmargin at screen 0.075; set rmargin at screen 0.515; set tmargin at screen 0.975; set bmargin at screen 0.115
set xrange [0.008:last * 1.3]; set yrange [1.44:2.06]
set ytics 0.1 format '%.1f'
set ylabel '|{/:Italic W̄}| at pull-off' offset 1,0
set label 1 '(a)' at graph 0.03, graph 0.955 left
set key at graph 0.98, graph 0.86 right top Right noreverse
set arrow 1 from graph 0, first 2 to graph 1, first 2 nohead dashtype 3 linewidth 1.2 linecolor rgb grey
set arrow 2 from graph 0, first 1.5 to graph 1, first 1.5 nohead dashtype 3 linewidth 1.2 linecolor rgb grey
plot for [k = 1:count] 'force.dat' index k-1 using 1:2 with linespoints pointtype shape[k] pointsize 0.6 linewidth 1.1 \
       linecolor rgb colour[k] title name[k], \
     for [k = 1:theory] 'force.dat' index count using 1:2 with lines linewidth 1.3 dashtype 2 linecolor rgb black title 'Maugis–Dugdale'
unset arrow 1; unset arrow 2; set key off; unset mytics

# (b) and (c)
set logscale y; set format y decade; set ytics auto; set ytics 10
set lmargin at screen 0.615; set rmargin at screen 0.985
array panel_data[2] = ['rigid.dat', 'jkr.dat']
array panel_mark[2] = ['(b)', '(c)']
array panel_label[2] = ['2 − |{/:Italic W̄}|', '|{/:Italic W̄}| − 1.5']
do for [p = 1:2] {
  set tmargin at screen (p == 1 ? 0.975 : 0.475); set bmargin at screen (p == 1 ? 0.60 : 0.115)
  if (p == 1) { unset xlabel; set xrange [0.008:1.2]; set yrange [1e-4:1] } else {
    set xlabel 'Tabor parameter μ' offset 0,0.3; set xrange [0.85:last * 1.3]; set yrange [*:*] }
  set ylabel panel_label[p] offset 0.5,0
  set label 1 panel_mark[p] at graph (p == 1 ? 0.03 : 0.9), graph 0.9 left
  plot for [k = 1:count] panel_data[p] index k-1 using 1:2 with linespoints pointtype shape[k] pointsize 0.6 linewidth 1.1 \
         linecolor rgb colour[k] notitle, \
       for [k = 1:theory] panel_data[p] index count using 1:2 with lines linewidth 1.3 dashtype 2 linecolor rgb black notitle
}
unset multiplot
