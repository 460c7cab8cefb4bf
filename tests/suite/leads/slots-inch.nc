(machine: haas-vf2)
(set: tools.1.diameter=0.5in)
(Usual forms of entering and leaving a slot of .8 by 3 in with a tool of .5 in. Each is quiet.)
(The slot's middle is X0 Y0; its ends are half circles of .4 about X-1.1 and X1.1.)
G20 G17 G40 G90
T1 M6
S1000 M3
F10.
(1 From the middle of the slot to a wall by a line, and back.)
G0 X0 Y0 Z.1
G1 Z-.5
G41 D1 X0 Y-.4
X1.1
G3 X1.1 Y.4 R.4
G1 X-1.1
G3 X-1.1 Y-.4 R.4
G1 X0
G40 Y0
G0 Z.1
(2 From the middle by a quarter circle, and back.)
G0 X0 Y0
G1 Z-.5
G41 D1 X-.35 Y-.05
G3 X0 Y-.4 R.35
G1 X1.1
G3 X1.1 Y.4 R.4
G1 X-1.1
G3 X-1.1 Y-.4 R.4
G1 X0
G3 X.35 Y-.05 R.35
G1 G40 X0 Y0
G0 Z.1
(3 A half circle that touches the middle line, run .1 in past the start.)
G0 X-.3 Y0
G1 Z-.5
G41 D1 X0 Y.25
G3 X0 Y-.4 R.325
G1 X1.1
G3 X1.1 Y.4 R.4
G1 X-1.1
G3 X-1.1 Y-.4 R.4
G1 X.1
G3 X.1 Y.25 R.325
G1 G40 X-.3 Y0
G0 Z.1
(4 Begun in the round end.)
G0 X0 Y0
G1 Z-.5
G41 D1 X1.15 Y-.35
G3 X1.5 Y0 R.35
G3 X1.1 Y.4 R.4
G1 X-1.1
G3 X-1.1 Y-.4 R.4
G1 X1.1
G3 X1.5 Y0 R.4
G3 X1.15 Y.35 R.35
G1 G40 X0 Y0
G0 Z.1
(5 Begun in the round end, run past the start.)
G0 X0 Y0
G1 Z-.5
G41 D1 X1.15 Y-.35
G3 X1.5 Y0 R.35
G3 X1.1 Y.4 R.4
G1 X-1.1
G3 X-1.1 Y-.4 R.4
G1 X1.1
G3 X1.3828 Y.2828 R.4
G1 G40 X1. Y0
G0 Z.1
(6 A slot open on the right: in from outside along one wall, out along the other.)
G0 X3. Y0
G1 Z-.5
G41 D1 X2.5 Y.4
X-1.1
G3 X-1.1 Y-.4 R.4
G1 X2.5
G40 X3. Y0
G0 Z.1
(7 Two walls from the middle, each with its own offset.)
G0 X-1.1 Y0
G1 Z-.5
G41 D1 X-1.1 Y-.4
X1.1
G40 Y0
G41 D1 Y.4
X-1.1
G40 Y0
G0 Z.1
(8 Two walls in one offset, from one to the other by a line across.)
G0 X-1. Y0
G1 Z-.5
G41 D1 X-1. Y-.4
X1.
Y.4
X-1.
G40 Y0
G0 Z.1
(9 G42, the other way round.)
G0 X0 Y0
G1 Z-.5
G42 D1 X.35 Y-.05
G2 X0 Y-.4 R.35
G1 X-1.1
G2 X-1.1 Y.4 R.4
G1 X1.1
G2 X1.1 Y-.4 R.4
G1 X0
G2 X-.35 Y-.05 R.35
G1 G40 X0 Y0
G0 Z.1
M30
