# Load against minus the approach under several laws: a frame for each Tabor parameter.
# Data: computed.dat, for each frame a block for each law; maugis.dat and jkr.dat, a block for each frame.

set multiplot
gap = 0.075; left = 0.085; width = (0.985 - left - (frames - 1) * gap) / frames
do for [f = 1:frames] {
  set lmargin at screen left + (f - 1) * (width + gap); set rmargin at screen left + (f - 1) * (width + gap) + width
  set tmargin at screen 0.97; set bmargin at screen 0.145
  set xrange [x_low[f]:x_high[f]]; set yrange [-1.95:0.45]
  set xtics auto format '%g'; set ytics 0.5 format '%.1f'
  set xlabel '−Δ†' offset 0,0.3
  if (f == 1) { set ylabel 'load {/:Italic W̄}' offset 1.5,0 } else { unset ylabel }
  set label 1 frame_text[f] at graph 0.5, graph 0.94 center
  set key off
  if (f == frames) { set key at graph 0.05, graph 0.78 left top Left reverse }
  plot 'jkr.dat' index f-1 using 1:2 with lines linewidth 1.6 dashtype 3 linecolor rgb grey title 'JKR', \
       'maugis.dat' index f-1 using 1:2 with lines linewidth 1.3 dashtype 2 linecolor rgb black title 'Maugis–Dugdale', \
       for [k = 1:count] 'computed.dat' index (f-1)*count+k-1 using 1:2 with lines linewidth 1.3 \
         linecolor rgb colour[k] title name[k]
}
unset multiplot
