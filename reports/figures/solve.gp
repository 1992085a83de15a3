# One scene: the branch with its special points and jumps, the profile, the staircase; the panels that the data have.
# Data blocks: stable, unstable (a block for each part of the branch), folds, pull_off, jumps, profile, staircase, jkr.

columns = panel_count > 1 ? 2 : 1
rows = panel_count > 2 ? 2 : 1
panel = 0
left(k) = real((k - 1) % columns) / columns + (columns == 1 ? 0.085 : 0.1)
right(k) = real((k - 1) % columns + 1) / columns - 0.02
head = rows == 1 ? 0.07 : 0.045
top(k) = 1 - head - real((k - 1) / columns) * (1 - head) / rows - (k > columns ? 0.02 : 0.01)
bottom(k) = 1 - head - real((k - 1) / columns + 1) * (1 - head) / rows + (rows == 1 ? 0.125 : 0.075)
place = "panel = panel + 1; set lmargin at screen left(panel); set tmargin at screen top(panel); \
set bmargin at screen bottom(panel); set rmargin at screen right(panel)"

# A long command is continued on a second line, before an option.
cut = 140
if (strlen(caption) > cut) {
  while (cut > 1 && caption[cut:cut + 2] ne ' --') { cut = cut - 1 }
  caption = caption[1:cut - 1]."\n     ".caption[cut:*]
}
set multiplot
set label 1 caption at screen 0.015, screen 1 - 0.45 * head left noenhanced font ',8' textcolor rgb grey
if (has_curve) {
  eval place
  set xlabel 'approach Δ†/ε' offset 0,0.4
  set ylabel '{/:Italic W}/'.load_unit offset 1,0
  set xrange [*:*]; set yrange [*:*]; set offsets graph 0.03, graph 0.03, graph 0.05, graph 0.05
  if (panel_count == 3) { set key at screen 0.6, screen 0.4 left top Left reverse } \
  else { set key at graph 0.02, graph 0.97 left top Left reverse font ',9' spacing 1.1 } # above the branch of bodies far apart
  do for [i = 1:jump_count] {
    x = real(word($jumps[i], 1)); from = real(word($jumps[i], 2)); to = real(word($jumps[i], 3))
    set arrow i from x, from to x, to filled size screen 0.012,20 front linewidth 1.1 dashtype 3 \
      linecolor rgb (int(word($jumps[i], 4)) ? black : blue)
  }
  plot for [i = 1:unstable_count] $unstable index i-1 using 1:2 with lines linecolor rgb vermillion \
         linewidth 0.8 dashtype 2 title (i == 1 ? 'unstable' : ''), \
       for [i = 1:stable_count] $stable index i-1 using 1:2 with lines linecolor rgb vermillion linewidth 2 \
         title (i == 1 ? 'stable at given approach' : ''), \
       $folds using 1:2 with points pointtype 6 pointsize 0.5 linewidth 1.1 linecolor rgb black title 'fold', \
       $pull_off using 1:2 with points pointtype 7 pointsize 0.6 linecolor rgb black title 'pull-off', \
       for [i = 1:(jump_count > 0)] 1/0 with lines linecolor rgb black linewidth 1.1 dashtype 3 title 'jump in loading', \
       for [i = 1:(jump_count > 0)] 1/0 with lines linecolor rgb blue linewidth 1.1 dashtype 3 title 'jump in unloading'
  unset arrow; unset label 1; set offsets
}
if (has_profile) {
  eval place
  set rmargin at screen right(panel) - 0.055
  # The profile reaches to large radii, where nothing happens: the axis ends where the tension is 1 % of the greatest.
  stats $profile using 3 name 'traction' nooutput
  least = 0.01 * (abs(traction_min) > abs(traction_max) ? abs(traction_min) : abs(traction_max))
  stats $profile using (abs($3) > least ? $1 : NaN) name 'radius' nooutput
  reach = 1.15 * radius_max
  stats $profile using ($1 < reach ? $2 : NaN) name 'gap' nooutput
  set xrange [0:reach]; set yrange [*:*]; set y2range [*:*]
  set xlabel sprintf('radius {/:Italic r}/ε, at approach %.4f ε', profile_approach) offset 0,0.4
  set ylabel '{/:Italic P} = {/:Italic p}με/{/:Italic w}' offset 1,0 textcolor rgb vermillion
  set y2label 'gap {/:Italic H}' offset -1,0 textcolor rgb blue
  set ytics nomirror; set y2tics; set offsets 0, 0, graph 0.05, graph 0.05
  set key off
  plot $profile using ($1 <= 1.1 * reach ? $1 : NaN):3 smooth mcsplines linecolor rgb vermillion linewidth 1.6, \
       $profile using ($1 <= 1.1 * reach ? $1 : NaN):2 axes x1y2 smooth mcsplines linecolor rgb blue linewidth 1.2 dashtype 4
  unset label; unset y2tics; unset y2label; set offsets
}
if (has_staircase) {
  eval place
  # The JKR theory knows steps at preloads far beyond those that were traced.
  stats $staircase using 1 name 'preload' nooutput
  extent = preload_max - preload_min
  set xrange [preload_min - 0.05 * extent:preload_max + 0.1 * extent]; set yrange [0:*]; set offsets 0, 0, graph 0.1, 0
  set xlabel 'preload, largest approach Δ†/ε' offset 0,0.4
  set ylabel 'pull-off force/'.load_unit offset 1,0 textcolor rgb black
  set key at graph 0.98, graph 0.03 right bottom Left reverse font ',9' spacing 1.1
  plot for [i = 1:has_jkr] $jkr using 1:2 with lines linewidth 1.2 dashtype 2 linecolor rgb sky title 'JKR, Eq 5', \
       $staircase using 1:2 with linespoints pointtype 7 pointsize 0.25 linewidth 1.8 linecolor rgb vermillion title 'computed'
}
unset multiplot
unset output
