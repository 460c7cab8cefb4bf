(machine: haas-vf2)
(G51 by one factor, G68, and G101, which mirrors about the work zero.)
G20 G17 G90 G94 S500 M3
G0 X0 Y0 Z0 (= rapid to X0 Y0 Z0)
G51 X1.5 Y1.5 P2
G0 X1. Y1. (= rapid to X.5 Y.5)
X2. Y2. (= rapid to X2.5 Y2.5)
G2 X3. Y2. R.5 F10. (= arc cw to X4.5 Y2.5 radius 1.00 sweep 180.00)
G50
G0 X0 Y0
G68 X0 Y0 R60.
X1. Y1. (= rapid to X-.366025 Y1.366025)
G69
G101 X0
G0 X2. Y1. (= rapid to X-2 Y1)
G100 X0
X2. Y1. (= rapid to X2 Y1)
G107 A0 Y0 R2. (= none)
G1 Y1.0471975512 F10. (= line to Y1.0471975512)
G107
G0 Z1. (= rapid from A30)
M30
