(machine: haas-vf2)
(set: tools.1.diameter=0.5in)
(Usual forms of entering and leaving a boss of 4 by 3 in with a tool of .5 in. Each is quiet.)
(The lower left corner of the boss is X0 Y0.)
G20 G17 G40 G90
T1 M6
S1000 M3
F10.
(1 Line square to the wall at its middle, round, line off.)
G0 X-1. Y1.5 Z.1
G1 Z-.5
G41 D1 X0
Y3.
X4.
Y0
X0
Y1.5
G40 X-1.
G0 Z.1
(2 Quarter circles on and off at the middle of a wall.)
G0 X-1.5 Y1.
G1 Z-.5
G41 D1 X-.5 Y1.
G3 X0 Y1.5 R.5
G1 Y3.
X4.
Y0
X0
Y1.5
G3 X-.5 Y2. R.5
G1 G40 X-1.5
G0 Z.1
(3 Up to the corner along the line of the wall, round, and off beyond the corner.)
G0 X-.5 Y-1.5
G1 Z-.5
G41 D1 X0 Y-1.
Y3.
X4.
Y0
X-1.
G40 X-1.5 Y-.5
G0 Z.1
(4 A quarter circle on, run .2 in past the start, a quarter circle off.)
G0 X-1.5 Y1.
G1 Z-.5
G41 D1 X-.5 Y1.
G3 X0 Y1.5 R.5
G1 Y3.
X4.
Y0
X0
Y1.7
G3 X-.5 Y2.2 R.5
G1 G40 X-1.5
G0 Z.1
(5 Through the start: on .2 in before it, off .2 in beyond.)
G0 X-1. Y1.
G1 Z-.5
G41 D1 X0 Y1.3
Y3.
X4.
Y0
X0
Y1.7
G40 X-1. Y2.
G0 Z.1
(6 Begun at a corner: line on, line off.)
G0 X-1. Y-1.
G1 Z-.5
G41 D1 X0 Y-.4
Y3.
X4.
Y0
X-.4
G40 X-1. Y-1.
G0 Z.1
(7 A corner kept sharp by a loop beyond it.)
G0 X-1. Y1.5
G1 Z-.5
G41 D1 X0
Y3.
Y3.4
G3 X-.4 Y3. R-.4
G1 X0
X4.
Y0
X0
Y1.5
G40 X-1.
G0 Z.1
(8 G42 the other way round, half circles on and off.)
G0 X-2. Y2.3
G1 Z-.5
G42 D1 X-1. Y2.3
G1 X-.8
G2 X0 Y1.5 R.8
G1 Y0
X4.
Y3.
X0
Y1.5
G2 X-.8 Y.7 R.8
G1 X-1.
G40 X-2.
G0 Z.1
(9 A round boss: line on, full circle, line off in the line of the tangent's square.)
G0 X-2. Y6.
G1 Z-.5
G41 D1 X-1. Y6.
G2 I1.
G1 G40 X-2.
G0 Z.1
(10 A round boss: quarter circles on and off.)
G0 X-2.5 Y5.5
G1 Z-.5
G41 D1 X-1.5 Y5.5
G3 X-1. Y6. R.5
G2 I1.
G3 X-1.5 Y6.5 R.5
G1 G40 X-2.5
G0 Z.1
(11 A round boss in two halves, run a sixth past the start.)
G0 X-2.5 Y5.5
G1 Z-.5
G41 D1 X-1.5 Y5.5
G3 X-1. Y6. R.5
G2 X1. Y6. R1.
G2 X-1. Y6. R1.
G2 X-.5 Y6.866 R1.
G1 X0 Y7.366
G40 Y8.
G0 Z.1
(12 Two depths, the plunge off the part.)
G0 X-1. Y1.5
G1 Z-.25
G41 D1 X0
Y3.
X4.
Y0
X0
Y1.5
G40 X-1.
G1 Z-.5
G41 D1 X0
Y3.
X4.
Y0
X0
Y1.5
G40 X-1.
G0 Z.1
(13 A line on, then a quarter circle; a quarter circle, then a line off: all with the offset.)
G0 X-2. Y.8
G1 Z-.5
G41 D1 X-1.5 Y.8
G1 X-.5 Y1.
G3 X0 Y1.5 R.5
G1 Y3.
X4.
Y0
X0
Y1.5
G3 X-.5 Y2. R.5
G1 X-1.5 Y2.2
G40 X-2.
G0 Z.1
M30
