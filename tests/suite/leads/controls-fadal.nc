(machine: fadal-4020)
(set: tools.1.diameter=0.5in)
(The bore rolled on from its centre and a boss on a Fadal. Each is quiet.)
G20 G17 G40 G90
T1 M6
S1000 M3
F10.
(1 Rolled on from the centre.)
G0 X.3 Y0 Z.1
G1 Z-.5
G41 D1 X0
G3 X1. Y0 I.5
G3 I-1.
G3 X0 Y0 I-.5
G1 G40 X.3
G0 Z.1
(2 Quarter circles.)
G0 X0 Y0
G1 Z-.5
G41 D1 X.5 Y-.5
G3 X1. Y0 J.5
G3 I-1.
G3 X.5 Y.5 I-.5
G1 G40 X0 Y0
G0 Z.1
M30
