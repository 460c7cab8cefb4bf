(machine: haas-vf2)
(set: tools.1.diameter=0.5in)
(Usual forms of entering and leaving a bore of 2 in with a tool of .5 in. Each is quiet.)
G20 G17 G40 G90
T1 M6
S1000 M3
F10.
(1 Rolled on from the centre, one full circle, rolled off to the centre.)
G0 X.3 Y0 Z.1
G1 Z-.5
G41 D1 X0
G3 X1. Y0 R.5
G3 I-1.
G3 X0 Y0 R.5
G1 G40 X.3 (= line to X.3)
G0 Z.1
(2 Rolled on from the centre, two halves.)
G0 X.3 Y0
G1 Z-.5
G41 D1 X0
G3 X1. Y0 R.5
G3 X-1. Y0 R1.
G3 X1. Y0 R1.
G3 X0 Y0 R.5
G1 G40 X.3
G0 Z.1
(3 Rolled on from the centre, four quarters.)
G0 X.3 Y0
G1 Z-.5
G41 D1 X0
G3 X1. Y0 R.5
G3 X0 Y1. R1.
G3 X-1. Y0 R1.
G3 X0 Y-1. R1.
G3 X1. Y0 R1.
G3 X0 Y0 R.5
G1 G40 X.3
G0 Z.1
(4 Two quarter circles, from and to the centre by a line.)
G0 X0 Y0
G1 Z-.5
G41 D1 X.5 Y-.5
G3 X1. Y0 R.5
G3 I-1.
G3 X.5 Y.5 R.5
G1 G40 X0 Y0
G0 Z.1
(5 A line straight to the wall, a full circle, a line back.)
G0 X0 Y0
G1 Z-.5
G41 D1 X1. Y0
G3 I-1.
G1 G40 X0 Y0
G0 Z.1
(6 Rolled on, a quarter of a turn beyond the start, rolled off.)
G0 X.3 Y0
G1 Z-.5
G41 D1 X0
G3 X1. Y0 R.5
G3 I-1.
G3 X0 Y1. R1.
G3 X0 Y0 R.5
G1 G40 X.3
G0 Z.1
(7 The other way round on the right of it.)
G0 X.3 Y0
G1 Z-.5
G42 D1 X0
G2 X1. Y0 R.5
G2 I-1.
G2 X0 Y0 R.5
G1 G40 X.3
G0 Z.1
(8 A helix of three turns from the top, a level turn, rolled off.)
G0 X.3 Y0
G1 Z0
G41 D1 X0
G3 X1. Y0 R.5
G3 I-1. Z-.1
G3 I-1. Z-.2
G3 I-1. Z-.3
G3 I-1.
G3 X0 Y0 R.5
G1 G40 X.3
G0 Z.1
(9 Rolled on while going down, and rolled off while coming up.)
G0 X.3 Y0
G1 Z0
G41 D1 X0
G3 X1. Y0 R.5 Z-.1
G3 I-1.
G3 X0 Y0 R.5 Z0
G1 G40 X.3
G0 Z.1
(10 G40 alone after the lead-out; the next move takes the offset away.)
G0 X.3 Y0
G1 Z-.5
G41 D1 X0
G3 X1. Y0 R.5
G3 I-1.
G3 X0 Y0 R.5
G40
G1 X.3
G0 Z.1
(11 A spring pass: the circle twice.)
G0 X.3 Y0
G1 Z-.5
G41 D1 X0
G3 X1. Y0 R.5
G3 I-1.
G3 I-1.
G3 X0 Y0 R.5
G1 G40 X.3
G0 Z.1
(12 A line and an arc, both with the offset.)
G0 X0 Y-.3
G1 Z-.5
G41 D1 X.4 Y-.3
G1 X.6 Y-.4
G3 X1. Y0 R.4
G3 I-1.
G3 X.6 Y.4 R.4
G1 X.4 Y.3
G1 G40 X0 Y0
G0 Z.1
M30
