%
(machine: mach3-mill)
(How Mach3 reads: units by two pairs of codes, parameters and expressions, centres of arcs, seconds of G4.)
G20 G17 G90 G94 G40 G49 G80 G50 G69 G15 G97
G0 X1 (= rapid to X25.4)
G71
X50 (= rapid to X50)
G70
X1 (= rapid to X25.4)
G21
#1=3
#2=[#1*2+0.5]
G0 X#1 Y#2 Z5 (= rapid to X3 Y6.5 Z5)
#1=10 X#1 (= rapid to X3)
X#1 (= rapid to X10)
X[SIN[30]*10] (= rapid to X5)
(AND, OR and XOR bind like plus.)
X[1 AND 0 + 2] (= rapid to X2)
X5
G0 X10 Y0
S1000 M3
G1 Z-1 F100
G2 X20 I5 J0 (= arc cw center X15 Y0 radius 5 to X20 Y0)
G90.1
G3 X10 Y0 I15 J0 (= arc ccw center X15 Y0 radius 5 to X10 Y0)
G91.1
G2 X20 Y0 R5 (= arc cw center X15 Y0 radius 5)
G2 X20 Y0 I5 J0 (= arc cw radius 5 sweep 360)
G2 X20 Y0 I6 J0 Z-2 (= helix cw radius 6 sweep 360 to X20 Y0 Z-2)
G4 P1.5 (= dwell 1.5)
G4 P2 (= dwell 2)
G0 Z5
G61
G64
G53 G0 Z20 (= rapid to Z20)
G92 X0 Y0
X1 (= rapid to X1 length 1)
G92.1
X1 (= rapid to X1)
G52 X10
X1 (= rapid to X1 length 10)
G52 X0
G91
X1 (= rapid to X12)
G90
M47 (= ! CH204 "M47")
%
