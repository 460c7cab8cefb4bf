(machine: haas-vf2)
(units: inch)
(A radius that is a little longer than half the chord has its centre beside the middle: by 0.01414 in where the)
(chord is 3.9999 and R 2: the root of 2 times 2 less 1.99995 times 1.99995.)
G20 G17 G90 G94
G0 X0 Y0 Z0
S1000 M3
G2 X3.9999 R2. F10. (= arc cw center X1.99995 Y-0.014142 radius 2 to X3.9999 Y0)
G0 X0
G3 X3.9999 R2. (= arc ccw center X1.99995 Y0.014142 radius 2 to X3.9999 Y0)
G0 X0
(A radius that is too short by less than two increments is a half circle.)
G2 X4.0001 R2. (= arc cw center X2.00005 Y0 to X4.0001 Y0)
M30
