# Figure 8: pull-off force against the Tabor parameter; at the top, the JKR limit beyond the axis of the paper, on a
# logarithmic axis; at the bottom, the difference from the paper's discretisation. Data: computed.dat, harder.dat (at
# any preload), guduru.dat, difference.dat, each with a block for each amplitude.

set multiplot
set lmargin at screen 0.098; set rmargin at screen 0.985
set logscale x
set xrange [0.0085:6]
set xtics 10 format ''; set mxtics 10

# the JKR limit above the axis of the paper
set tmargin at screen 0.985; set bmargin at screen 0.815
set logscale y; set yrange [top:above]; set ytics (1e2, 1e3, 1e4, 1e5) format '10^{%L}'
unset key
set label 98 '(a)' at graph 0.012, graph 0.16 left
set label 1 sprintf('JKR, A† = 10: %.1f at μ = 5', last) at last_tabor, last right offset 0.3,1.5 textcolor rgb colour[3]
plot for [i = 1:guduru_count] 'guduru.dat' index i-1 using 1:2 with lines linecolor rgb colour[i] \
       linewidth 1.1 dashtype 2 notitle, \
     '+' using (last_tabor):(last) every ::0::0 with points pointtype 6 pointsize 0.9 linewidth 1.2 \
       linecolor rgb colour[3] notitle
unset label 1
set label 98 '(b)' at graph 0.985, graph 0.95 right

set tmargin at screen 0.81; set bmargin at screen 0.315
unset logscale y; set yrange [0:top]
set ytics 0, 1, top - 1 format '%g'; set mytics 2
set ylabel '|{/:Italic W̄}| at pull-off' offset 0,0
set key at graph 0.02, graph 0.955 left top Left reverse
do for [i = 1:rigid_count] {
  set arrow i from graph 0, first rigid[i] to graph 1, first rigid[i] nohead \
    linewidth 1.1 linecolor rgb colour[i] dashtype 4
}
plot NaN with lines linecolor rgb black linewidth 1.1 dashtype 2 title 'JKR limit, Eq 5', \
     NaN with lines linecolor rgb black linewidth 1.1 dashtype 4 title 'rigid limit, Eq 22', \
     for [i = 1:guduru_count] 'guduru.dat' index i-1 using 1:2 with lines linecolor rgb colour[i] \
       linewidth 1.1 dashtype 2 notitle, \
     for [i = 1:count] 'computed.dat' index i-1 using 1:2 with points pointtype shape[i] \
       pointsize 0.85 linewidth 1.3 linecolor rgb colour[i] title text[i], \
     for [i = 1:count] 'harder.dat' index i-1 using 1:2 with points pointtype shape[i] + 1 \
       pointsize 0.7 linecolor rgb colour[i] notitle, \
     'links.dat' index 0 @link

unset arrow
set label 98 '(c)' at graph 0.012, graph 0.85 left
set tmargin at screen 0.28; set bmargin at screen 0.09
set xtics 10 format '%g'
set xlabel 'Tabor parameter μ' offset 0,0.4
set logscale y
set yrange [low:high]; set ytics auto format '10^{%L}'; set ytics 10.0**ceil(log10(high / low) / 4.0)
set arrow 9 from graph 0, first cut to graph 1, first cut nohead dashtype 2 linewidth 0.9 linecolor rgb black
unset mytics
set ylabel 'abs. difference' rotate by 90 offset 0.5,0
set key off
plot for [i = 1:strip_count] 'difference.dat' index i-1 using 1:2 with linespoints \
       pointtype shape[i] pointsize 0.5 linewidth 0.7 linecolor rgb colour[i] notitle
unset multiplot
