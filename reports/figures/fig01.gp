# Figure 1: sketch of the contact, Eqs 1 and 2.

unset border; unset tics; unset grid; unset key
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set xrange [-10:10]; set yrange [-2.6:3.4]; set samples 500
A = 0.35; L = 2.5; R = 22.0
set arrow 1 from -10,0 to 10,0 nohead linewidth 0.7 dashtype 2 linecolor rgb grey back
set arrow 2 from 0,-2.2 to 0,3.2 head filled size 0.25,15 linewidth 0.8 linecolor rgb grey front
set label 2 '{/:Italic z}' at 0.2,3.1 left textcolor rgb grey front
set label 3 '{/:Italic r}' at 9.7,0.25 right textcolor rgb grey front
set arrow 4 from L,0.28 to 2*L,0.28 heads filled size 0.2,15 linewidth 0.9 front
set label 4 'λ' at 1.5*L,0.5 center front
set arrow 5 from -1.5*L,0 to -1.5*L,-2*A heads filled size 0.15,15 linewidth 0.9 front
set label 5 '2{/:Italic A}' at -1.5*L-0.2,0.3 right front
set label 6 'rigid sphere, radius {/:Italic R}' at -5,2.6 center front
set label 7 'elastic half-space, {/:Italic E}, ν' at 0.6,-1.75 left front
plot -A*(1-cos(2*pi*x/L)) with filledcurves y1=-2.6 fillcolor rgb '#E3EEF6' notitle, \
     -A*(1-cos(2*pi*x/L)) with lines linewidth 1.5 linecolor rgb blue notitle, \
     x**2/(2*R)+0.55 with filledcurves y1=3.4 fillcolor rgb '#EFEFEF' notitle, \
     x**2/(2*R)+0.55 with lines linewidth 1.5 linecolor rgb black notitle
