(machine: linuxcnc-mill)
(units: mm)
(expect: CH531)
(set: tools.1.diameter="2 mm")
(What a control refuses in splines, with its own text.)
G21 G90 G17 F1000 S1000 M3
G0 X0 Y0 Z0
G5 X1 Y1 I0 J3 P0 (= line to X1 Y1 | ! CH419 "without Q" "Must specify both P and Q with G5")
G5 X2 Y2 I1 P0 Q-1 (= line to X2 Y2 | ! CH419 "with I and without J" "Must specify both I and J, or neither")
G5.1 X3 Y3 I1 (= line to X3 Y3 | ! CH419 "without J" "Must specify both I and J with G5.1")
G5.1 X4 Y4 Z1 I1 J1 (= line to X4 Y4 | ! CH424 "Z in a spline" "Splines may not have motion in Z")
G18 G5.1 X5 Y5 I1 J1 (= line to X5 Y5 | ! CH424 "G18" "Splines must be in the XY plane")
G17 G0 X0 Y0
G5.3 (= none | ! CH422 "without control points" "Cannot use G5.3 without G5.2 first")
G0 X0 Y0
G5.2 X1 P1 (= none | ! CH420 "with X and without Y" "You must specify both X and Y coordinates for Control Points")
X2 Y2 (= none | ! CH421 "without its weight" "Must specify positive weight P for every Control Point")
P3 (= none | ! CH420 "P without X and Y")
X3 Y3 P-1 (= none | ! CH421 "weight -1")
G5.3 (= spline to X3 Y3)
G0 X0 Y0
G5.2 X1 Y1 P1 L4
X2 Y0 P1
G5.3 (= line to X2 Y0 | ! CH423 "needs 4 control points; this one has 3" "at least equal to the order L = 4")
G0 X0 Y0
G5.2 X1 Y1 P1 L7
X2 Y0 P1
X3 Y1 P1
X4 Y0 P1
X5 Y1 P1
X6 Y0 P1
G5.3 (= line to X6 Y0 | ! CH426 "order 7")
G0 X0 Y0
G5.2 X1 Y1 P1
X2 Y0 P1
G1 X3 (= line from X0 Y0 to X3 Y0 | ! CH422 "3 control points since G5.2 are not cut")
G40 G0 X0 Y0
G41 D1 G1 X10 Y0
X20
G5.1 X30 Y0 I5 J5 (= line to X30 Y0 | ! CH425 "compensation" "Cannot convert spline with cutter radius compensation")
G40 G1 X40
G5.2 X1 Y1 P1 (= none)
M2 (= ! CH422 "2 control points since G5.2 are not cut")
