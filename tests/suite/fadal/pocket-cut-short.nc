(machine: fadal-4020)
(set: tools.1.diameter="0.5 in")
(A pocket in G91 whose contour is cut short does not come back to its middle; the whole one does.)
L100 (CUT SHORT
G91 X1.5 G41 G1
Y.98
X-.52 Y.52 I-.52 G3
X-1.56 G40
G90 Z.1 G0
M17 (= ! CH214 "X -0.58 in, Y 1.5 in")
L200 (WHOLE
G91 X1.5 G41 G1
Y.98
X-.52 Y.52 I-.52 G3
X-1.96
X-.52 Y-.52 J-.52 G3
Y-1.96
X.52 Y-.52 I.52 G3
X1.96
X.52 Y.52 J.52 G3
Y.98
X-1.5 G40
G90 Z.1 G0
M17
M30
M6 T1
G0 G90 S2000 M3 E1 X0 Y0 D1
H1 Z.1
G1 Z-.1 F10.
L101
G0 X5. Y0
G1 Z-.1
L201 (= none)
G0 H0 Z0
M2
