# The pull-off forces of a run in which two numbers vary, as colours.
# Data block map: x, y, the borders of the cell in x and in y, and the force. Cells without a pull-off are empty. Each
# cell is covered by its neighbours on the right and above, so that no gap shows between them.

set lmargin at screen 0.12; set rmargin at screen 0.85
set tmargin at screen 0.92; set bmargin at screen 0.13
set label 1 caption at screen 0.015, screen 0.965 left noenhanced font ',8' textcolor rgb grey
set label 2 'pull-off force/'.load_unit at graph 1.02, screen 0.945 left font ',9'
set xlabel x_name noenhanced offset 0,0.4
set ylabel y_name noenhanced offset 1,0
set tics out
unset grid
unset key
# lightness increases with the force (viridis)
set palette defined (0 '#440154', 1 '#472D7B', 2 '#3B528B', 3 '#2C728E', 4 '#21918C', 5 '#28AE80', 6 '#5EC962', 7 '#ADDC30', 8 '#FDE725')
set colorbox vertical user origin screen 0.87, screen 0.13 size screen 0.03, screen 0.79
set cbtics in scale 0.5
plot $map using 1:2:3:4:5:6:7 with boxxyerror fillstyle solid 1 noborder linecolor palette notitle
unset output
