(machine: fadal-4020)
(The O form: a main program, and two programs that it calls. A pocket of 3 by 3 with .52 corners,)
(entered by four turns of a helix that ends in the middle.)
O100 (MAIN
M6 T1 (END MILL 1.0
G0 G90 S2000 M3 E1 X0 Y0
H1 Z.1 M7
G1 Z0 F10.
M98 P102
Z.1 G0
M5 M9
G90 G0 H0 Z0
M2
O101 (ONE TURN OF THE HELIX
G91 I-.5 G3 Z-.1
M99
O102 (POCKET
G91 X.5 G1
M98 P101 L4
X.5 F25.
Y.48
X-.52 Y.52 I-.52 G3
X-.96
X-.52 Y-.52 J-.52 G3
Y-.96
X.52 Y-.52 I.52 G3
X.96
X.52 Y.52 J.52 G3
Y.48
X-1.
G90
M99
