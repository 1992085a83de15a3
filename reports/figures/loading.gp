# Figures 12 and 13: load against minus the approach over the Tabor parameter, the path of a test marked.
# Data: stable.dat, unstable.dat, triangle.dat (a block a stretch), smooth.dat, guduru.dat.

set lmargin at screen 0.085; set rmargin at screen 0.985
set tmargin at screen 0.98; set bmargin at screen 0.115
set xrange [x_min:x_max]; set yrange [y_min:y_max]
set xtics 0.5 format '%g'; set ytics 0.5 format '%.1f'
set xlabel '−Δ†/μ' offset 0,0.4
set ylabel '{/:Italic W̄}' rotate by 0 offset 1.5,0
if (key_below) { set key at graph 0.02, graph 0.03 left bottom Left reverse } else { set key at graph 0.985, graph 0.975 right top Left reverse }
do for [i = 1:arrow_count] {
  set arrow i from arrow_x[i], arrow_from[i] to arrow_x[i], arrow_to[i] filled size screen 0.012,20 front \
    linewidth 1.1 linecolor rgb (arrow_back[i] ? blue : black) dashtype 3
}
do for [i = 1:label_count] {
  set label i label_text[i] at label_x[i], label_y[i] center front \
    offset -1.1 * label_left[i], 0.6 * label_above[i] \
    textcolor rgb (label_loading[i] ? black : blue) point pointtype 7 pointsize 0.35 \
    linecolor rgb (label_loading[i] ? black : blue)
}
set label 1000 'preload' at preload_x, preload_y left front offset 0.6,0.5 point pointtype 4 pointsize 0.7
plot 'smooth.dat' using 1:2 with lines linecolor rgb black linewidth 1.0 dashtype 4 title 'JKR, smooth', \
     'guduru.dat' using 1:2 with lines linecolor rgb sky linewidth 1.4 dashtype 2 title 'JKR, wavy (Equation 5)', \
     for [i = 1:triangle_count] 'triangle.dat' index i-1 using 1:2 with lines \
       linecolor rgb grey linewidth 0.7 title (i == 1 ? '500 triangles' : ''), \
     for [i = 1:unstable_count] 'unstable.dat' index i-1 using 1:2 with lines \
       linecolor rgb vermillion linewidth 0.8 title (i == 1 ? 'panels, unstable' : ''), \
     for [i = 1:stable_count] 'stable.dat' index i-1 using 1:2 with lines \
       linecolor rgb vermillion linewidth 2.2 title (i == 1 ? 'panels, stable' : '')
