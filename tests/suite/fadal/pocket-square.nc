(machine: fadal-4020)
(set: tools.1.diameter="0.5 in")
(A 2.96 square before the contour of 3.00 is finished. Tool radius .25, flat .235: rings at most)
(.40118 apart; to 1.23 in four rings, .3075 apart. L96 goes counter-clockwise, L97 clockwise.)
M6 T1
G90 G0 S8000 M3 E1 X0 Y0
H1 D1 Z.1 M8
G1 Z-.35 F10.
L9601 R0+10. R1+.015 R2+2.96 R3+2.96 (= line to X-.3075 Y0 feed 10 | line to X-.3075 Y-.3075 | line to X.3075 Y-.3075 | line to X.3075 Y.3075)
(= line to X-.3075 Y.3075 | line to X-.3075 Y0 | line x12 | line to X-1.23 Y0 | line to X-1.23 Y-1.23 | line to X1.23 Y-1.23)
(= line to X1.23 Y1.23 | line to X-1.23 Y1.23 | line to X-1.23 Y0 | line to X0 Y0 Z-.35)
L9701 R0+10. R1+.015 R2+2.96 R3+2.96 (= line to X-.3075 Y0 | line to X-.3075 Y.3075 | line to X.3075 Y.3075 | line to X.3075 Y-.3075)
(= line to X-.3075 Y-.3075 | line to X-.3075 Y0 | line x12 | line to X-1.23 Y0 | line to X-1.23 Y1.23 | line to X1.23 Y1.23)
(= line to X1.23 Y-1.23 | line to X-1.23 Y-1.23 | line to X-1.23 Y0 | line to X0 Y0 Z-.35)
(Upright: the middle line stands along Y. 1.5 x 2.5: reach .5 and 1, two rings of .25.)
L9601 R0+10. R1+0 R2+1.5 R3+2.5 (= line to X0 Y.5 | line to X0 Y-.5 | line to X0 Y-.75 | line to X.25 Y-.75 | line to X.25 Y.75)
(= line to X-.25 Y.75 | line to X-.25 Y-.75 | line to X0 Y-.75 | line to X0 Y-1 | line to X.5 Y-1 | line to X.5 Y1 | line to X-.5 Y1)
(= line to X-.5 Y-1 | line to X0 Y-1 | line to X0 Y0)
(The modes are as they were: G1 and F of the program.)
X.1 (= line to X.1 Y0 feed 10)
G90 G0 Z.1
H0 Z0
M2
