# |Deviation| of the theories from the computed pull-off force of a smooth sphere, in per cent: deviations.dat, a block a theory.
set logscale xy
set xrange [0.01:100]; set yrange [1e-2:60]
set xlabel 'Tabor parameter μ' offset 0,0.3; set ylabel '|deviation|, %' offset 1,0
set format x '10^{%L}'
set ytics ('0.01' 0.01, '0.1' 0.1, '1' 1, '5' 5, '20' 20)
set rmargin at screen 0.72; set lmargin at screen 0.085
set key at screen 0.735, screen 0.93 left top Left reverse samplen 1.8
array colour[6] = [grey, vermillion, black, green, purple, blue]
plot for [k = 1:count] 'deviations.dat' index k-1 using 1:2 with linespoints pointtype 7 pointsize 0.25 linewidth 1.3 \
  linecolor rgb colour[k] title name[k]
