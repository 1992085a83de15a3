# Figures 12 and 13: load against minus the approach over the Tabor parameter, with the jumps of a test; with
# `wide`, the same in a larger frame at the top. Data: stable.dat, unstable.dat (a block for each part of the branch),
# triangle.dat, smooth.dat, guduru.dat, theory.dat (a block for each jump of the JKR theory).

set multiplot
set lmargin at screen 0.085; set rmargin at screen 0.985
set xtics format '%g'
set ylabel '{/:Italic W̄}' rotate by 0 offset 1.5,0

if (wide_count) {
  set tmargin at screen 0.985; set bmargin at screen 0.685
  set xtics 1
  set xrange [wide[1]:wide[2]]; set yrange [wide[3]:wide[4]]; set ytics 2 format '%g'; set mytics 2
  set key at graph 0.02, graph 0.05 left bottom Left reverse
  set object 1 rectangle from x_min, y_min to x_max, y_max fillstyle empty border linecolor rgb grey linewidth 1.2
  set label 1 '(a)' at graph 0.02, graph 0.93 left
  plot 'smooth.dat' using 1:2 with lines linecolor rgb black linewidth 1.0 dashtype 4 title 'JKR, smooth', \
       'guduru.dat' using 1:2 with lines linecolor rgb sky linewidth 1.4 dashtype 2 title 'JKR, wavy (Equation 5)', \
       for [i = 1:theory_count] 'theory.dat' index i-1 using 1:2 with lines linecolor rgb purple linewidth 1.6 notitle, \
       for [i = 1:unstable_count] 'unstable.dat' index i-1 using 1:2 with lines \
         linecolor rgb vermillion linewidth 0.8 notitle, \
       for [i = 1:stable_count] 'stable.dat' index i-1 using 1:2 with lines \
         linecolor rgb vermillion linewidth 1.6 title (i == 1 ? 'panels' : '')
  unset object 1
  unset mytics
  set label 1 '(b)' at graph 0.02, graph 0.95 left
}

set tmargin at screen (wide_count ? 0.63 : 0.98); set bmargin at screen (wide_count ? 0.075 : 0.115)
set xrange [x_min:x_max]; set xtics 0.5; set yrange [y_min:y_max]; set ytics 0.5 format '%.1f'
set xlabel '−Δ†/μ' offset 0,0.4
if (key_below) { set key at graph 0.015, graph 0.985 left top Left reverse samplen 1.6 } \
else { if (wide_count) { set key at graph 0.02, graph 0.03 left bottom Left reverse } \
else { set key at graph 0.985, graph 0.975 right top Left reverse } }
do for [i = 1:arrow_count] {
  set arrow i from arrow_x[i], arrow_from[i] to arrow_x[i], arrow_to[i] filled size screen 0.012,20 front \
    linewidth 1.1 linecolor rgb (arrow_back[i] ? blue : black) dashtype 3
}
do for [i = 1:label_count] {
  set label i+1 label_text[i] at label_x[i], label_y[i] center front \
    offset -1.1 * label_left[i], 0.6 * label_above[i] \
    textcolor rgb (label_loading[i] ? black : blue) point pointtype 7 pointsize 0.35 \
    linecolor rgb (label_loading[i] ? black : blue)
}
set label 1000 'preload' at preload_x, preload_y left front offset 0.6,0.5 point pointtype 4 pointsize 0.7
plot 'smooth.dat' using 1:2 with lines linecolor rgb black linewidth 1.0 dashtype 4 title (wide_count ? '' : 'JKR, smooth'), \
     'guduru.dat' using 1:2 with lines linecolor rgb sky linewidth 1.4 dashtype 2 \
       title (wide_count ? '' : 'JKR, wavy (Equation 5)'), \
     for [i = 1:theory_count] 'theory.dat' index i-1 using 1:2 with lines linecolor rgb purple linewidth 1.8 \
       title (i == 1 ? 'jumps by Eq 5' : ''), \
     for [i = 1:unstable_count] 'unstable.dat' index i-1 using 1:2 with lines \
       linecolor rgb vermillion linewidth 0.8 title (i == 1 ? 'panels, unstable' : ''), \
     for [i = 1:stable_count] 'stable.dat' index i-1 using 1:2 with lines \
       linecolor rgb vermillion linewidth 2.2 title (i == 1 ? 'panels, stable' : ''), \
     for [i = 1:(triangle_count > 0)] 'triangle.dat' using 1:2 with points pointtype 8 pointsize 0.55 linewidth 0.9 \
       linecolor rgb '#404040' title '500 triangles'
unset multiplot
