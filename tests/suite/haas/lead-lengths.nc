(machine: haas-vf2)
(set: tools.1.diameter=0.5in)
(A lead-in must move X or Y, and by more than the offset of .25.)
T1 M6
G20 G17 G40 G90 S1000 M3
G0 X0 Y0 Z0
G1 F10.
G41 D1 X.25 (= line to X.25 | ! CH510 "the lead-in of 0.25 in")
Y3. (= line to Y3)
G40 X0 (= line to X0)
Y0
G41 X.2501 (= line to X.2501)
Y3.
G40 X0
Y0
G41 Z-.1 (= line to Z-.1 | ! CH510 "moves only Z")
X1.
Y3.
G40 Z0 (= line to Z0 | ! CH510 "does not move in the plane")
X0
(An arc code in the block of a code that takes the axis words.)
G53 G2 X-10. I1. (= line | ! CH302 "G2 makes no arc")
G54 G1 X0 Y0
G3 I-.5 L0 (= none | ! CH303 "not executed")
G3 I-.5 Z-.1 L2 (= helix ccw to Z-.1 | arc ccw | ! CH213 "1 are flat")
M30
