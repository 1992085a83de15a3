# Figure 4: (a) pull-off force and (b) minus the approach at pull-off against the Tabor parameter,
# with the absolute differences from the reference, (c) and (d), below; (e) the number of folds. Data: force.dat and approach.dat, each
# with the blocks computed, reference, residual, tolerance, published, and residual of the paper's discretisation; folds.dat.

# Heights on the screen: everything moves up if (e) is drawn below.
below = fold_points ? 0.235 : 0
high(y) = below + (1 - below) * y

set multiplot
set logscale x
set xrange [0.0075:6.7]
set xtics (0.01, 0.1, 1, 5); set mxtics 10
set xtics add ('' 0.02 1, '' 0.03 1, '' 0.04 1, '' 0.05 1, '' 0.06 1, '' 0.07 1, '' 0.08 1, \
  '' 0.09 1, '' 0.2 1, '' 0.3 1, '' 0.4 1, '' 0.5 1, '' 0.6 1, '' 0.7 1, '' 0.8 1, '' 0.9 1, \
  '' 2 1, '' 3 1, '' 4 1)

array panel_name[2] = ['force', 'approach']
array panel_left[2] = [0.085, 0.59]
array panel_right[2] = [0.485, 0.988]
array panel_low[2] = [force_low, approach_low]
array panel_high[2] = [force_high, approach_high]
array panel_tolerance[2] = [force_tolerance, approach_tolerance]
array panel_reference[2] = [force_reference, approach_reference]
array panel_limits[2] = [force_limits, approach_limits]
array panel_crosses[2] = [force_crosses, approach_crosses]
array panel_label[2] = ['|{/:Italic W̄}| at pull-off', '−Δ† at pull-off']

do for [k = 1:2] {
  data = panel_name[k] . '.dat'
  set lmargin at screen panel_left[k]; set rmargin at screen panel_right[k]

  set tmargin at screen high(0.985); set bmargin at screen high(0.40)
  unset logscale y; set format x ''; unset xlabel
  if (k == 1) { set yrange [1.45:2.08]; set ytics 0.1; set format y '%.1f' }
  else { set yrange [-0.3:4.3]; set ytics 1; set format y '%g' }
  set ylabel panel_label[k] offset (k == 1 ? 1 : 0),0
  set label 1 (k == 1 ? '(a)' : '(b)') at graph 0.03, graph 0.955 left
  if (k == 1) { set key at graph 0.04, graph 0.05 left bottom Left reverse }
  else { set key off }
  plot data index 1 using 1:2 with points pointtype 3 pointsize 0.75 linewidth 1.1 \
         linecolor rgb black title (panel_reference[k] ? 'reference, Feng’s problem' : ''), \
       data index 0 using 1:2 with points pointtype 4 pointsize 0.85 linewidth 1.2 \
         linecolor rgb blue title 'panels', \
       for [i = 1:(panel_crosses[k] > 0)] data index 4 using 1:2 with points pointtype 1 \
         pointsize 0.9 linewidth 1.25 linecolor rgb black title 'Feng, read off a figure', \
       'links.dat' index k-1 @link

  set tmargin at screen high(0.365); set bmargin at screen high(0.115)
  set key off
  set logscale y; set yrange [panel_low[k]:panel_high[k]]
  unset mytics; set ytics auto; set ytics 10.0**ceil(log10(panel_high[k] / panel_low[k]) / 4.0)
  set format y '10^{%L}'; set format x '%g'
  set xlabel 'Tabor parameter μ' offset 0,0.3
  set ylabel 'abs. difference' offset 1,0
  set label 1 (k == 1 ? '(c)' : '(d)') at graph 0.03, graph 0.88 left
  if (panel_limits[k]) {
    set label 2 'tolerance' at 0.0095, panel_tolerance[k] left offset 0,-0.65 textcolor rgb grey
  }
  if (k == 1 && paper) { set arrow 9 from graph 0, first cut to graph 1, first cut nohead dashtype 2 linewidth 0.9 linecolor rgb black }
  plot data index 3 using 1:2 with steps dashtype 2 linewidth 1 linecolor rgb grey notitle, \
       data index 2 using 1:2 with linespoints pointtype 7 pointsize 0.35 linewidth 0.7 \
         linecolor rgb blue notitle, \
       for [i = 1:paper] data index 5 using 1:2 with linespoints pointtype 6 pointsize 0.45 linewidth 0.7 \
         linecolor rgb vermillion notitle
  unset label 2; unset arrow 9
}

# Folds: the scale shows 0, and distinguishes 2 from 4 next to dozens.
if (fold_points) {
  unset logscale y; set lmargin at screen panel_left[1]; set rmargin at screen panel_right[2]
  set tmargin at screen 0.235; set bmargin at screen 0.085
  set nonlinear y via log10(1 + y) inverse 10**y - 1
  set yrange [-0.35:130]; set format y '%g'; set ytics (0, '' 2, 4, 10, 30, 100)
  set xrange [0.0075:6.7]
  set ylabel 'folds' offset 0,0
  set label 1 '(e)' at graph 0.015, graph 0.86 left
  set key at graph 0.06, graph 0.92 left top Left reverse
  plot 'folds.dat' index 0 using 1:2 with linespoints pointtype 4 pointsize 0.7 linewidth 0.9 \
         linecolor rgb blue title 'panels', \
       for [i = 1:paper] 'folds.dat' index 1 using 1:2 with linespoints pointtype 6 pointsize 0.45 \
         linewidth 0.9 linecolor rgb vermillion title 'paper’s discretisation, cut at r = R', \
       'links.dat' index 2 @link
}
unset multiplot
