%
O154
(machine: haas-vf2)
(set: tools.1.diameter="0.25 in")
(Two rooms with a throat of .2, which a tool of .25 does not pass: the room of the hole is milled.)
(In the throat's mouth the border is two arcs of .125 about its corners, which meet at)
(X1 - root of .015625 - .01 = .925; the row Y.525 ends on the second at X.9. The straight way to)
(it would cut the corner, so the link follows the border. The far wall is 2.5 - .925 - .125 away.)
T1 M06
G00 G90 G17 G40 G49 G54 X0.4 Y0.45 S2000 M03
G43 H01 Z0.1 M08
G91 G150 P7 Z-0.2 R-0.05 J0.2 G41 D01 F12. (= rapid to Z.05 | line to X.4 Y.45 Z-.15 feed 12 | line to X.125 Y.45 | line to X.125 Y.125 | line to X.875 Y.125 | line to X.875 Y.4)
(= arc cw center X1 Y.4 radius .125 sweep 53.1301 to X.925 Y.5 | arc cw center X1 Y.6 radius .125 sweep 53.1301 to X.875 Y.6)
(= line to X.875 Y.875 | line to X.125 Y.875 | line to X.125 Y.45 | line to X.125 Y.325 | line to X.875 Y.325)
(= line to X.875 Y.4 | arc cw center X1 Y.4 radius .125 sweep 53.1301 to X.925 Y.5 | arc cw center X1 Y.6 sweep 16.2602 to X.9 Y.525)
(= line to X.125 Y.525 | line to X.125 Y.725 | line to X.875 Y.725 | line to X.4 Y.45 Z-.15)
(= ! CH827 "1.45 in away from the wall at X 2.5 in, Y 0.5 in")
G90 G00 Z0.1 M09
M30
N7 G90 G01 X0 Y0
X1.
Y0.4
X1.5
Y0
X2.5
Y1.
X1.5
Y0.6
X1.
Y1.
X0
Y0
M99
%
