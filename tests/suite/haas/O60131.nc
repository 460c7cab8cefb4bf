%
O60131
(machine: haas-vf2)
(set: tools.1.diameter="0.625 in")
(A round pocket in four steps. From Z.1 they end at -.4, -.9, -1.4 and -1.9, not at the 2.000 that)
(the text of the example has. Tool radius .3125: centre lines of .1875, .4875 and .6875.)
(ends at: X0 Y0 Z.1)
T1 M06
G00 G90 G40 G49 G54 X0 Y0 S4000 M03
G43 H01 Z0.1 M08
G13 G91 Z-0.5 I0.5 K1. Q0.3 L4 D01 F20. (= line to X0 Y0 Z-.4 feed 20 | arc ccw x7 | line to X0 Y0 Z-.9 | arc ccw x7 | line to Z-1.4 | arc ccw x7)
(= line to Z-1.9 | arc ccw radius .09375 sweep 180 to X.1875 Y0 | arc ccw radius .1875 sweep 360 | arc ccw radius .3375 sweep 180 to X-.4875 Y0)
(= arc ccw radius .4875 sweep 360 | arc ccw radius .5875 sweep 180 to X.6875 Y0 | arc ccw radius .6875 sweep 360 | arc ccw radius .34375 sweep 180 to X0 Y0 Z-1.9)
G00 Z2. (= rapid to Z.1)
M30
%
