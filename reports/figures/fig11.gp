# Figure 11: effective work of adhesion against the Johnson parameter. Data: computed.dat (a block for
# each pair of wavelength and radius, radii fastest), clear.dat (the same, for markers clearly below Eq 30), harder.dat (the same,
# at any preload), envelope.dat (Eq 24), tosatti.dat (Eq 30).

set logscale xy
set xrange [0.03:250]; set yrange [0.02:20]
set xtics 10 format '%g'; set mxtics 10; set ytics 10 format '%g'; set mytics 10
set xlabel 'Johnson parameter α_{KLJ}' offset 0,0.3
set ylabel '{/:Italic w}_{eff}/{/:Italic w}' offset 1,0
do for [k = 1:clear_count] { set label k clear_text[k] at clear_x[k], clear_y[k] left offset 1,-0.6 }
set key at graph 0.985, graph 0.03 right bottom Left reverse
plot 'envelope.dat' using 1:2 with lines linewidth 1.4 linecolor rgb blue title 'Eq 24, Kesari–Lew', \
     'tosatti.dat' using 1:2 with lines linewidth 1.4 dashtype 4 linecolor rgb vermillion \
       title 'Eq 30, Persson–Tosatti', \
     for [i = 1:wavelength_count] NaN with points pointtype shape[i] pointsize 0.7 linewidth 1.1 \
       linecolor rgb black title wavelength_text[i], \
     for [i = 1:radius_count] NaN with points pointtype 7 pointsize 0.6 linecolor rgb colour[i] \
       title radius_text[i], \
     for [k = 0:wavelength_count*radius_count-1] 'computed.dat' index k using 1:2 with linespoints \
       pointtype shape[k/radius_count + 1] pointsize 0.5 linewidth 0.5 dashtype 3 \
       linecolor rgb colour[k % radius_count + 1] notitle, \
     for [k = 0:wavelength_count*radius_count-1] 'clear.dat' index k using 1:2 with points \
       pointtype shape[k/radius_count + 1] + 1 pointsize 0.6 linecolor rgb colour[k % radius_count + 1] notitle, \
     for [k = 0:wavelength_count*radius_count-1] 'harder.dat' index k using 1:2 with points \
       pointtype 2 pointsize 0.6 linewidth 1.2 linecolor rgb colour[k % radius_count + 1] notitle
