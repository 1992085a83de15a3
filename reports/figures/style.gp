# Settings of all figures: terminal, typeface, palette, frame.
# The width of 680 fills the text width of a page; font size 11, the smallest in the report, is then 8.2 points, and 7.0 points
# at 86 % of that width, as print.css has it.

if (!exists("figure_height")) figure_height = 480
if (!exists("figure_width")) figure_width = 680

# The places of links to scenes, 'links.dat' index N @link: the report replaces these marks by links (pulloff_report/live.py).
link = "using 1:2:(sprintf('link %d', $3)) with labels hypertext point pointtype 7 pointsize 1 notitle"

set encoding utf8
# The report embeds SVG; `pulloff plot` also draws PNG and PDF, to standard output.
if (!exists("figure_terminal")) figure_terminal = 'svg'
if (!exists("figure_output")) figure_output = 'figure.svg'
if (figure_terminal eq 'svg') set terminal svg size figure_width,figure_height enhanced font 'Inter,11' linewidth 1
if (figure_terminal eq 'png') set terminal pngcairo size 2*figure_width,2*figure_height enhanced font 'Inter,11' fontscale 1.5 \
  linewidth 2 pointscale 2
if (figure_terminal eq 'pdf') set terminal pdfcairo size figure_width/72.0,figure_height/72.0 enhanced font 'Inter,11' linewidth 1.3
if (figure_output eq '') { set output } else { set output figure_output }
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
