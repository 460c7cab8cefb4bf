%
O60131
(machine: haas-vf2)
(set: tools.1.diameter="0.25 in")
(Round pockets. Tool radius .125: circles of .3 .6 .9 1.2 1.5 have centre lines of .175 .475 .775)
(1.075 1.375; with the half circles 11.625 pi = 36.5210 and .3 down. Steps of .3 with a tool of)
(.25 leave rings of .05.)
(total: feed_length 50.8981)
T1 M06
G00 G90 G40 G49 G54 X0 Y0 S1000 M03
G43 H01 Z0.1
G13 Z-0.2 I0.3 K1.5 Q0.3 D01 F10. (= line to X0 Y0 Z-.2 feed 10 | arc ccw center X.0875 Y0 radius .0875 sweep 180 to X.175 Y0 | arc ccw center X0 Y0 radius .175 sweep 360 to X.175 Y0 feed 10)
(= arc ccw center X-.15 Y0 radius .325 sweep 180 to X-.475 Y0 | arc ccw center X0 Y0 radius .475 sweep 360)
(= arc ccw center X.15 Y0 radius .625 sweep 180 to X.775 Y0 | arc ccw radius .775 sweep 360)
(= arc ccw radius .925 sweep 180 to X-1.075 Y0 | arc ccw radius 1.075 sweep 360)
(= arc ccw radius 1.225 sweep 180 to X1.375 Y0 | arc ccw radius 1.375 sweep 360 length 8.63938)
(= arc ccw center X.6875 Y0 radius .6875 sweep 180 to X0 Y0 Z-.2 | ! CH826 "0.05 in")
(One circle with the D of before: centre line .625, and 1.875 pi = 5.8905 with the half circles.)
G12 I0.75 (= arc cw center X.3125 Y0 radius .3125 sweep 180 to X.625 Y0 | arc cw center X0 Y0 radius .625 sweep 360 length 3.92699 | arc cw center X.3125 Y0 radius .3125 sweep 180 to X0 Y0)
(D0 follows the size as it is. X and Y first, by the motion in force.)
G01
G12 X1. Y0.5 I0.75 D00 (= line to X1 Y.5 Z-.2 | arc cw radius .375 sweep 180 to X1.75 Y.5 | arc cw center X1 Y.5 radius .75 sweep 360 | arc cw sweep 180 to X1 Y.5)
G00 Z0.1
M30
%
