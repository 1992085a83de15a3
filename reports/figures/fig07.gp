# Figure 7: pull-off of rigid wavy spheres against alpha; below, the relative difference from Eq 22.
# Data: rigid.dat (a block for each amplitude), computed.dat, doubled.dat and printed.dat (a block for
# each radius), residual.dat (panels, the paper's).

set multiplot
set lmargin at screen 0.088; set rmargin at screen 0.91
set tmargin at screen 0.985; set bmargin at screen 0.365
set logscale xy
set xrange [1e-4:100]; set yrange [2e-4:4]
set xtics 10 format ''; set mxtics 10; set ytics 10 format '10^{%L}'; set mytics 10
set ylabel '|{/:Italic W̄}| at pull-off' offset 0.5,0
set key at graph 0.02, graph 0.04 left bottom Left reverse
set label 98 '(a)' at graph 0.012, graph 0.42 left
do for [i = 1:line_count] {
  set label i line_text[i] at graph 1.008, first line_end[i] left
}
do for [i = 1:rumpf_count] {
  set label 20+i rumpf_text[i] at graph 1.062, first rumpf_end[i] left textcolor rgb green
}
plot for [i = 1:rumpf_count] 'printed.dat' index i-1 using 1:2 with lines \
       linecolor rgb green linewidth 0.6 dashtype 3 title (i == 1 ? 'Eq 20 as printed, log_{10} R†' : ''), \
     for [i = 1:rumpf_count] 'doubled.dat' index i-1 using 1:2 with lines \
       linecolor rgb green linewidth 1.1 dashtype 2 title (i == 1 ? 'Eq 20 doubled, log_{10} R†' : ''), \
     for [i = 1:line_count] 'rigid.dat' index i-1 using 1:2 with lines \
       linecolor rgb black linewidth 1.2 title (i == 1 ? 'Eq 22, log_{10} A†' : ''), \
     'computed.dat' using 1:2 with points pointtype 4 pointsize 0.65 linewidth 1.2 \
       linecolor rgb blue title 'panels, μ = 10^{−4}'

unset label
set label 98 '(b)' at graph 0.012, graph 0.1 left
set tmargin at screen 0.335; set bmargin at screen 0.105
set xtics 10 format '10^{%L}'
set xlabel 'α' offset 0,0.4
set yrange [low:high]; set ytics auto format '10^{%L}'; set ytics 10.0**ceil(log10(high / low) / 4.0)
unset mytics
set ylabel 'relative difference' rotate by 90 offset 0.5,0
set key horizontal at graph 0.02, graph 0.95 left top Left reverse
plot 'residual.dat' index 0 using 1:2 with points pointtype 7 pointsize 0.35 linecolor rgb blue \
       title 'panels, unbounded', \
     'residual.dat' index 1 using 1:2 with points pointtype 6 pointsize 0.45 linecolor rgb vermillion \
       title 'paper’s, cut at r = R'
unset multiplot
