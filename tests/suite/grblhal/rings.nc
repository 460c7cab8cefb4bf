(machine: grblhal)
(units: mm)
(A helix of one turn needs no axis of the plane with a centre, and one with R.)
G21 G17 G90 G94
S1000 M3 F100
G0 X0 Y0 Z0
G3 Z1 I-2.5 (= helix ccw center X-2.5 Y0 sweep 360 to X0 Y0 Z1)
G2 J2 Z0 (= helix cw center X0 Y2 sweep 360 to X0 Y0 Z0)
G3 I1 (= arc ccw center X1 Y0 sweep 360 to X0 Y0)
M2
