# Figure 5: sketches of the models of Rumpf and Rabinowicz, and of Guduru.

unset border; unset tics; unset grid; unset key
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set xrange [-10:10]; set yrange [-1.6:4.4]; set samples 700
A = 0.3; L = 1.9; R = 5.5; s = 0.75
left(x) = x < -0.4 ? (abs(x+5.2) < s ? sqrt(s**2-(x+5.2)**2) : 0) : NaN
right(x) = x > 0.4 ? s - A*(1-cos(2*pi*(x-5.2)/L)) : NaN
ball(x, c) = abs(x-c) < 4.7 ? s + 0.08 + R - sqrt(R**2-(x-c)**2) : NaN
set label 1 '{/:Italic R}' at -5.2,3.3 center front
set label 2 '{/:Italic r}_2' at -4.2,0.55 left front
set label 3 'Rumpf–Rabinowicz' at -5.2,-1.2 center front
set label 4 '{/:Italic R}' at 5.2,3.3 center front
set label 5 'Guduru' at 5.2,-1.2 center front
set arrow 6 from 5.2,0.03 to 5.2+L,0.03 heads filled size 0.2,15 linewidth 0.9 front
set label 6 'λ' at 5.2+L/2,-0.2 center front
plot left(x) with filledcurves y1=-0.8 fillcolor rgb '#E3EEF6' notitle, \
     right(x) with filledcurves y1=-0.8 fillcolor rgb '#E3EEF6' notitle, \
     left(x) with lines linewidth 1.5 linecolor rgb blue notitle, \
     right(x) with lines linewidth 1.5 linecolor rgb blue notitle, \
     ball(x, -5.2) with lines linewidth 1.5 linecolor rgb black notitle, \
     ball(x, 5.2) with lines linewidth 1.5 linecolor rgb black notitle
