# SPDX-License-Identifier: Apache-2.0
# Lays out the pictures: pins as traces one above the other, below them rate or position. Called by draw.sh.
set terminal svg size 760,360 dynamic font "sans-serif,11" background "white"
set key off
set border 3 lc rgb "#606060"
set xtics nomirror
set ytics nomirror
ink = "#1f3b73"; second = "#b5482a"; third = "#3a7d44"

pins_above = "set size 1,0.5; set origin 0,0.5; set lmargin 12; set rmargin 3; set bmargin 1; set xlabel; set format x ''"
curve_below = "set size 1,0.5; set origin 0,0; set bmargin 3; set format x '%g'; set xlabel 'clocks'"

set output pictures."/ramp.svg"
set multiplot
eval pins_above
set xrange [0:22500]
set yrange [-0.2:2.6]
set ytics ("Y step" 0.35, "X step" 1.85)
plot "ramp.txt" u 1:($2*0.7+1.5) w l lc rgb ink, "" u 1:($4*0.7) w l lc rgb second
eval curve_below
set yrange [0:4.5]
set ytics 1
set ylabel "X steps/1000 clocks"
plot "ramp.txt" u 1:7 w l lc rgb ink
unset multiplot
unset ylabel

set output pictures."/reversal.svg"
set multiplot
set xrange [0:1400]
eval pins_above
set yrange [-0.2:4.1]
set ytics ("Y step" 0.35, "X direction" 1.85, "X step" 3.35)
plot "reversal.txt" u 1:($2*0.7+3) w l lc rgb ink, "" u 1:($3*0.7+1.5) w l lc rgb third, \
  "" u 1:($4*0.7) w l lc rgb second
eval curve_below
set yrange [-0.5:4.5]
set ytics 1
set ylabel "X position"
plot "reversal.txt" u 1:6 w l lc rgb ink
unset multiplot
unset ylabel

set output pictures."/hold.svg"
set multiplot
set xrange [0:25000]
eval pins_above
set yrange [-0.2:2.6]
set ytics ("Y step" 0.35, "X step" 1.85)
set arrow 1 from 5000,-0.2 to 5000,2.5 nohead dt 2 lc rgb third
set arrow 2 from 12000,-0.2 to 12000,2.5 nohead dt 2 lc rgb third
set label 1 "hold" at 5000,2.5 right offset -0.5,0 tc rgb third
set label 2 "resume" at 12000,2.5 offset 0.5,0 tc rgb third
plot "hold.txt" u 1:($2*0.7+1.5) w l lc rgb ink, "" u 1:($4*0.7) w l lc rgb second
unset arrow
unset label
eval curve_below
set yrange [0:*]
set ytics auto
set ylabel "X position"
plot "hold.txt" u 1:6 w l lc rgb ink
unset multiplot
unset ylabel

set output pictures."/stop.svg"
set multiplot
set xrange [0:12000]
eval pins_above
set yrange [-0.2:4.1]
set ytics ("end stop" 0.35, "X, braking" 1.85, "X, at once" 3.35)
plot "stop.txt" u 1:($2*0.7+3) w l lc rgb ink, "brake.txt" u 1:($2*0.7+1.5) w l lc rgb second, \
  "" u 1:($5*0.7) w l lc rgb third
eval curve_below
set yrange [0:*]
set ytics auto
set ylabel "X position"
plot "brake.txt" u 1:6 w l lc rgb second, "stop.txt" u 1:6 w l lc rgb ink
unset multiplot
