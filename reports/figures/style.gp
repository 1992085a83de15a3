# Settings of all figures: terminal, typeface, palette, frame.
# The width of 680 fills the text width of a page; font size 11 is then about 8 points, and 7 points at 85 % of that width.

if (!exists("figure_height")) figure_height = 480
if (!exists("figure_width")) figure_width = 680

set encoding utf8
set terminal svg size figure_width,figure_height enhanced font 'Inter,11' linewidth 1
set output 'figure.svg'
set minussign

# The palette of Okabe and Ito, which colour-blind readers can distinguish.
black = '#000000'; blue = '#0072B2'; green = '#009E73'; vermillion = '#D55E00'
orange = '#E69F00'; purple = '#CC79A7'; sky = '#56B4E9'; grey = '#7A7A7A'; pale = '#D9D9D9'

set border 15 linewidth 0.8 linecolor rgb '#303030'
set tics scale 0.7, 0.4
set tics nomirror in
set grid linetype 1 linewidth 0.5 linecolor rgb '#E6E6E6', linetype 1 linewidth 0.4 linecolor rgb '#F2F2F2'
set grid back
set key samplen 2.2 spacing 1.25
