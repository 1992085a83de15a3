# (a) Whole solves against the number of waves in contact: waves.dat, blocks time, equilibria, nodes, expected time with dense matrices. (b) Rates of the parts of an
# equilibrium below those of the machine: rates.dat, a block for each part, compressed, then for each part, dense.

set multiplot
set logscale xy
set tmargin at screen 0.965; set bmargin at screen 0.145
array colour[3] = [blue, vermillion, green]
array filled[3] = [7, 5, 9]
array open[3] = [6, 4, 8]

# (a)
set lmargin at screen 0.085; set rmargin at screen 0.50
set xlabel 'wavelengths in the contact radius' offset 0,0.3
unset ylabel
set format x '%g'; set format y '%g'
set xrange [x_low:x_high]; set yrange [*:*]
set label 1 '(a)' at graph 0.03, graph 0.94 left
set key at graph 0.98, graph 0.28 right top Right noreverse
plot 'waves.dat' index 0 using 1:2 with linespoints pointtype 7 pointsize 0.55 linewidth 1.1 linecolor rgb black title 'processor time, s', \
     'waves.dat' index 3 using 1:2 with linespoints pointtype 6 pointsize 0.55 linewidth 1.1 dashtype 2 linecolor rgb black notitle, \
     'waves.dat' index 1 using 1:2 with linespoints pointtype 6 pointsize 0.6 linewidth 1.1 linecolor rgb orange title 'equilibria, thousands', \
     'waves.dat' index 2 using 1:2 with linespoints pointtype 8 pointsize 0.6 linewidth 1.1 linecolor rgb purple title 'nodes, thousands'

# (b)
set lmargin at screen 0.585; set rmargin at screen 0.99
set xlabel 'operations a byte' offset 0,0.3
set ylabel 'Gflop/s' offset 1,0
set format x '10^{%L}'; set format y '10^{%L}'
set xrange [0.1:900]; set yrange [1:4*peak_single]
set label 1 '(b)'
set label 2 'double' at first 700, first 0.76*peak right
set label 3 'single' at first 700, first 1.25*peak_single right
set key at graph 0.98, graph 0.27
set samples 500
plot (memory*x < peak ? memory*x : peak) with lines linewidth 1.2 linecolor rgb black notitle, \
     (memory*x < peak ? NaN : memory*x < peak_single ? memory*x : peak_single) with lines linewidth 1.2 dashtype 3 linecolor rgb black notitle, \
     for [k = 1:3] 'rates.dat' index k-1 using 1:2 with points pointtype filled[k] pointsize 0.9 linecolor rgb colour[k] title part[k], \
     for [k = 1:3] 'rates.dat' index k+2 using 1:2 with points pointtype open[k] pointsize 1.0 linewidth 1.3 linecolor rgb colour[k] notitle
unset multiplot
