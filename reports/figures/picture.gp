# The beginning of a picture of `pulloff`: its layout, and the styles of its series. The panels follow, each with its data,
# axes and ranges, between @place and @after.

# A long command is continued on a second line, before an option.
cut = 140
if (strlen(caption) > cut) {
  while (cut > 1 && caption[cut:cut + 2] ne ' --') { cut = cut - 1 }
  caption = caption[1:cut - 1]."\n     ".caption[cut:*]
}
columns = panel_count > 1 ? 2 : 1
rows = (panel_count + columns - 1) / columns
panel = 0
caption_height = (strstrt(caption, "\n") ? 30.0 : 18.0) / figure_height
left(k) = real((k - 1) % columns) / columns + 0.085 * (columns == 1 ? 1 : 1.1)
right(k) = real((k - 1) % columns + 1) / columns - 0.02
top(k) = 1 - caption_height - real((k - 1) / columns) * (1 - caption_height) / rows - 30.0 / figure_height
bottom(k) = 1 - caption_height - real((k - 1) / columns + 1) * (1 - caption_height) / rows + 44.0 / figure_height
place = "panel = panel + 1; set lmargin at screen left(panel) + 0.16 * has_names; set tmargin at screen top(panel); \
set bmargin at screen bottom(panel); set rmargin at screen right(panel) - 0.055 * has_second - (titles eq 'beside' ? 0.22 / columns : 0); \
if (has_second) { set ytics nomirror; set y2tics }; \
if (titles eq 'none') { set key off } else { if (titles eq 'above') \
{ set key at graph 0, graph 1.015 left bottom horizontal Left reverse noenhanced font ',9' samplen 1.6 width -1 maxrows 3 } else \
{ set key at graph 1.02, graph 1 left top vertical Left reverse noenhanced font ',8' } }"
after = "unset label 1; unset y2tics; unset y2label; set ytics mirror"

equilibria = "with lines linecolor rgb '#9A9A9A' linewidth 0.8 dashtype 3"
unstable = "with lines linecolor rgb vermillion linewidth 0.8 dashtype 2"
stable = "with lines linecolor rgb vermillion linewidth 2"
loading = "with lines linecolor rgb '#8CCBEE' linewidth 4.5"
unloading = "with lines linecolor rgb vermillion linewidth 1.2"
arrow = "filled size screen 0.012,20 linewidth 1.1"
jump_loading = "with vectors @arrow linecolor rgb blue"
jump_unloading = "with vectors @arrow linecolor rgb vermillion"
theory = "with lines linewidth 1.4 dashtype 2 linecolor rgb sky"
steps = "with linespoints pointtype 7 pointsize 0.25 linewidth 1.8 linecolor rgb vermillion"
curve = "with linespoints pointtype 7 pointsize 0.25 linewidth 1.4 linecolor"
line = "with lines linewidth 1.4 linecolor"
curve_error = "with yerrorbars pointtype 7 pointsize 0.25 linewidth 0.8 linecolor"
traction = "smooth mcsplines linecolor rgb vermillion linewidth 1.6"
gap = "axes x1y2 smooth mcsplines linecolor rgb blue linewidth 1.2 dashtype 4"
level = "with lines linewidth 1.8 linecolor rgb vermillion"
holds = "with points pointtype 7 pointsize 0.8 linecolor rgb black"
fails = "with points pointtype 6 pointsize 0.8 linewidth 1.2 linecolor rgb black"
unknown = "with points pointtype 2 pointsize 0.7 linewidth 1.2 linecolor rgb grey"
fold = "with points pointtype 6 pointsize 0.5 linewidth 1.1 linecolor rgb black"
pull_off = "with points pointtype 7 pointsize 0.6 linecolor rgb black"
set palette defined (0 '#0072B2', 0.35 '#009E73', 0.7 '#E69F00', 1 '#D55E00')
unset colorbox

set multiplot
set label 1 caption at screen 0.015, screen 1 - 0.5 * caption_height - 2.0 / figure_height left noenhanced font ',8' textcolor rgb grey
