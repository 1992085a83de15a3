# Processor time of an equilibrium (a) and of its parts (b) against the number of nodes. Data: equilibrium.dat: blocks
# compressed, dense, trace; parts.dat: a block for each part, compressed, then for each part, dense.

set multiplot
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xlabel 'nodes' offset 0,0.3
set xrange [x_low:x_high]
set tmargin at screen 0.965; set bmargin at screen 0.145
array colour[3] = [blue, vermillion, green]
array filled[3] = [7, 5, 9]
array open[3] = [6, 4, 8]

# (a)
set lmargin at screen 0.085; set rmargin at screen 0.50
set yrange [low[1]:high[1]]
set ylabel 'processor time, s' offset 1,0
set label 1 '(a)' at graph 0.03, graph 0.94 left
set key at graph 0.98, graph 0.27 right top Right noreverse
plot 'equilibrium.dat' index 0 using 1:2 with linespoints pointtype 7 pointsize 0.55 linewidth 1.1 linecolor rgb blue title 'compressed', \
     'equilibrium.dat' index 1 using 1:2 with linespoints pointtype 6 pointsize 0.6 linewidth 1.1 linecolor rgb vermillion title 'dense', \
     'equilibrium.dat' index 2 using 1:2 with linespoints pointtype 3 pointsize 0.6 linewidth 1.1 dashtype 2 linecolor rgb grey title 'trace, each equilibrium'

# (b)
set lmargin at screen 0.575; set rmargin at screen 0.99
unset ylabel
set yrange [low[2]:high[2]]
set label 1 '(b)'
set key at graph 0.98, graph 0.27
plot for [k = 1:3] 'parts.dat' index k-1 using 1:2 with linespoints pointtype filled[k] pointsize 0.55 linewidth 1.1 \
       linecolor rgb colour[k] title part[k], \
     for [k = 1:3] 'parts.dat' index k+2 using 1:2 with linespoints pointtype open[k] pointsize 0.6 linewidth 1.1 dashtype 2 \
       linecolor rgb colour[k] notitle
unset multiplot
