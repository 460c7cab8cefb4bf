(machine: fadal-4020)
(The O form put right: whole contour, and a main program that calls it.)
O3 (MAIN
M6 T1
G0 G90 S200 M3 E1 X0 Y0
H1 Z.1 M7
G1 Z.05 F10.
M98 P2
G0 G90 H0 Z0
E0 X0 Y0
M2
O1 (HELIX, ONE TURN DOWN
G91 I-.5 G3 Z-.1 (= helix ccw center X-.5 Y0 to Z-.05 | helix to Z-.15 | helix to Z-.25 | helix to Z-.35)
M99
O2 (POCKET
G91 D1
M98 P1 L4
X1.5 G41 G1
Y.98
X-.52 Y.52 I-.52 G3
X-1.96
X-.52 Y-.52 J-.52 G3
Y-1.96
X.52 Y-.52 I.52 G3
X1.96
X.52 Y.52 J.52 G3 (= arc ccw to X1.5 Y-.98)
Y.98 (= line to X1.5 Y0 Z-.35)
X-1.5 G40 (= line to X0 Y0)
G90 Z.1 G0
M99
