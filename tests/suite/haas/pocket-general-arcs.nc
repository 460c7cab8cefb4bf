%
O151
(machine: haas-vf2)
(set: tools.1.diameter="0.5 in")
(A slot with round ends, from another program, clockwise with G42, rows along Y. Radius .25, no)
(K: the border is a slot of .25 about X0 to X2 Y0. Rows at X-.25 + .4 = .15, .55, .95, 1.35, 1.75,)
(2.15. The border begins at X1, as the outline does. The hole X.7 Y.1 is nearest to Y.25. Beyond X2 a row is 2 root of .0625 - .0225 = .4 long.)
T1 M06
G00 G90 G17 G40 G49 G54 X0.7 Y0.1 S2000 M03
G43 H01 Z0.1 M08
G150 P152 Z-0.2 R0.1 I0.4 G42 D01 F12. (= line to X.7 Y.1 Z-.2 | line to X.7 Y.25 | line to X1 Y.25 | line to X2 Y.25)
(= arc cw center X2 Y0 radius .25 sweep 180 to X2 Y-.25 | line to X0 Y-.25 | arc cw center X0 Y0 radius .25 sweep 180 to X0 Y.25 | line to X.7 Y.25)
(= line to X.15 Y.25 | line to X.15 Y-.25 | line to X.55 Y-.25 | line to X.55 Y.25 | line to X.95 Y.25 | line to X.95 Y-.25)
(= line to X1.35 Y-.25 | line to X1.35 Y.25 | line to X1.75 Y.25 | line to X1.75 Y-.25 | line to X2.15 Y-.2 | line to X2.15 Y.2 | line to X.7 Y.1 Z-.2)
G00 Z0.1 M09
M30
O152
G01 X1. Y0.5
X2.
G02 X2. Y-0.5 R0.5
G01 X0
G02 X0 Y0.5 I0 J0.5
G01 X1.
M99
%
