# Pull-off force against preload: one column for each scene; displacement control at the top, load control at the bottom.
# Data: solver.dat, jkr.dat, each with a block for each frame, row by row.

set multiplot
gap = 0.055; left = 0.075; width = (0.985 - left - (scene_count - 1) * gap) / scene_count
array axis_text[2] = ['largest approach Δ†', 'largest load {/:Italic W̄}']
do for [row = 1:2] {
  do for [column = 1:scene_count] {
    frame = (row - 1) * scene_count + column
    set lmargin at screen left + (column - 1) * (width + gap)
    set rmargin at screen left + (column - 1) * (width + gap) + width
    set tmargin at screen (row == 1 ? 0.915 : 0.445); set bmargin at screen (row == 1 ? 0.60 : 0.115)
    set xrange [begin[frame] - 0.03 * (end[frame] - begin[frame]):end[frame]]; set yrange [0:top[frame]]
    set xtics step[frame] format '%g'; set ytics auto format '%g'
    set xlabel axis_text[row] offset 0,0.4
    if (column == 1) { set ylabel '|{/:Italic W̄}| at pull-off' offset 0.5,0 } else { unset ylabel }
    if (row == 1) { set label 1 title_text[column] at graph 0.5, graph 1.14 center; set label 3 title_more[column] at graph 0.5, graph 1.06 center } \
    else { unset label 1; unset label 3 }
    set label 2 sprintf('(%d)', column) at graph 0.04, graph 0.92 left
    set key off
    if (frame == key_frame) { set key at graph 0.04, graph 0.8 left top Left reverse samplen 1.5 }
    plot 'jkr.dat' index frame-1 using 1:2 with lines linewidth 1.2 dashtype 2 linecolor rgb sky title jkr_text, \
         'solver.dat' index frame-1 using 1:2 with lines linewidth 1.8 linecolor rgb vermillion title 'computed'
  }
}
unset multiplot
