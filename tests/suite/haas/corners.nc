%
O01234 (CORNER ROUNDING AND CHAMFERING, BETWEEN STRAIGHT CUTS)
(machine: haas-vf2)
G20 G17 G90 G94 S1000 M3
G0 X0 Y0 Z0
G1 X2. ,R.5 F10. (= line to X1.5 Y0 | arc ccw to X2 Y.5 center X1.5 Y.5 radius .50 feed 10)
Y2. ,C.25 (= line from X2 Y.5 to X2 Y1.75 | line to X1.75 Y2)
X0 ,R.25 (= line from X1.75 Y2 to X.25 Y2 | arc ccw to X0 Y1.75)
G4 P.5
Y1. (= line from X0 Y1.75 to X0 Y1)
(60 degrees to the left after a move to the right: the radius 0.1 takes 0.1 tan 60 of each, 0.173205.)
G91 X1. ,R.1 (= line to X.826795 Y1 | arc ccw to X.913397 Y1.15 radius .10 sweep 120.00)
X-1. Y1.7320508 (= line from X.913397 Y1.15)
G90
(The other planes.)
G0 X0 Y0 Z0
G18 G1 X1. ,C.25 (= line to X.75 Z0 | line to X1 Z-.25)
Z-1. (= line from X1 Z-.25 to Z-1)
G19 Y1. ,R.25 (= line to Y.75 Z-1 | arc cw plane yz to Y1 Z-1.25 radius .25)
Z-2. (= line from Y1 Z-1.25 to Z-2)
G17
(What cannot be.)
G1 X2. ,R.1 (= line to X2 Y1 | ! CH429 "the move is an arc" "between straight")
G2 X3. I.5 (= arc cw to X3 Y1)
G2 X4. I.5 ,R.1 (= arc cw to X4 Y1 | ! CH427 "the move is an arc")
G1 Y1.5 ,R.6 (= line to X4 Y1.5 | ! CH437 "0.6 in" "at most 0.5 in")
X6. ,C.1 (= line to X6 Y1.5 | ! CH428 "a block without a move")
T2
X6. Y3. (= line to X6 Y3)
M30
%
