(machine: haas-vf2)
(show: path)
(set: tools.1.diameter=0.5in)
(Leads that cut, with a tool of .5 in. Each is found, with its line.)
G20 G17 G40 G90
T1 M6
S1000 M3
F10.
(1 A bore of 2 in, left through its wall.)
G0 X.3 Y0 Z.1
G1 Z-.5
G41 D1 X0
G3 X1. Y0 R.5
G3 I-1.
G3 X0 Y0 R.5
G1 G40 X-.9 (= ! CH530 ".15 in")
G0 Z.1
(2 A bore entered from outside.)
G0 X2. Y-.5
G1 Z-.5
G41 D1 X.5 Y-.5 (= ! CH530)
G3 X1. Y0 R.5
G3 I-1.
G3 X.5 Y.5 R.5
G1 G40 X0 Y0
G0 Z.1
(3 A bore run past its start and left square to the wall, outward.)
G0 X0 Y0
G1 Z-.5
G41 D1 X.5 Y-.5
G3 X1. Y0 R.5
G3 I-1.
G3 X0 Y1. R1.
G1 G40 Y1.5 (= ! CH530)
G0 Z.1
(4 A boss of 4 by 3 in, started from its middle.)
G0 X2. Y1.5
G1 Z-.5
G41 D1 X0 (= ! CH530)
Y3.
X4.
Y0
X0
Y1.5
G40 X-1.
G0 Z.1
(5 A boss, left over its corner.)
G0 X-1. Y1.5
G1 Z-.5
G41 D1 X0
Y3.
X4.
Y0
X0
Y1.5
G40 X5. Y4. (= ! CH530)
G0 Z.1
(6 A boss whose lead-in crosses its corner.)
G0 X1. Y-1.
G1 Z-.5
G41 D1 X0 Y1.5 (= ! CH530)
Y3.
X4.
Y0
X0
Y1.5
G40 X-1.
G0 Z.1
(7 A boss, run past its start and left into the part.)
G0 X-1.5 Y1.
G1 Z-.5
G41 D1 X-.5 Y1.
G3 X0 Y1.5 R.5
G1 Y3.
X4.
Y0
X0
Y1.7
G2 X.5 Y2.2 R.5 (= ! CH530)
G1 G40 X2.
G0 Z.1
(8 The slot of .8: a lead-in that starts too near to the wall across.)
G0 X0 Y.3
G1 Z-.5
G41 D1 X0 Y-.4 (= ! CH530 ".15 in")
X1.1
G3 X1.1 Y.4 R.4
G1 X-1.1
G3 X-1.1 Y-.4 R.4
G1 X0
G40 Y0
G0 Z.1
(9 The same slot, left through its end.)
G0 X0 Y0
G1 Z-.5
G41 D1 X0 Y-.4
X1.1
G3 X1.1 Y.4 R.4
G1 X-1.1
G3 X-1.1 Y-.4 R.4
G1 X0
G40 X2. Y0 (= ! CH530)
G0 Z.1
(10 A round boss, entered along the line through its centre from the far side.)
G0 X2. Y6.
G1 Z-.5
G41 D1 X-1. Y6. (= ! CH530)
G2 I1.
G1 G40 X-2.
G0 Z.1
(11 A lead-in too short for the offset.)
G0 X0 Y-.3
G1 Z-.5
G41 D1 X0 Y-.2 (= ! CH510 | ! CH531)
X1.1
G40 Y.2
G0 Z.1
M30
