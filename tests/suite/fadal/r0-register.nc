(machine: fadal-4020)
(R words alone only store a value: no motion, no complaint, before an arc and after one.)
S1000 M3
G90 G0 X0 Y0 Z0
R0+.5 (= none)
G1 F20.
X1. R0+.5 G2 (= arc cw center X.5 Y0 radius .5 sweep 180 to X1 Y0)
R0+.75 (= none)
R1+.25 R2-.5 (= none)
X2. (= line to X2 Y0)
X+R0 Y-R2 (= line to X.75 Y.5)
X-R1 (= line to X-.25 Y.5)
M2
