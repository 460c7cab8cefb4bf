(machine: linuxcnc-mill)
(units: mm)
(Splines, exact. Lengths by a second formula, sums of chords of the basis functions.)
G21 G90 G17 F1000 S1000 M3
G0 X0 Y0 Z0
(cubic; the second block goes on in the direction in which the first ended. G5 and G5.1 hold for their block)
G5 I0 J3 P0 Q-3 X1 Y1 (= spline from X0 Y0 to X1 Y1 length 3.33096)
G5 P0 Q-3 X2 Y2 (= spline from X1 Y1 to X2 Y2 length 3.33096)
G1 X4 (= line from X2 Y2 to X4 Y2)
G5.1 X4 Y2 I1 J1 (= spline)
X5 (= line from X4 Y2 to X5 Y2)
(whatever stood between; the words of another letter leave it as it was)
G5 X6 Y3 P0 Q-3 (= spline to X6 Y3 length 3.33096)
(quadratic, incremental)
G0 X0 Y0
G91 G5.1 X10 Y0 I5 J10 (= spline from X0 Y0 to X10 Y0 length 14.78943)
G90
(a NURBS of order 4; the first point is where the tool stands)
G0 X0 Y0
G5.2 X1 Y2 P1 L4 (= none)
X3 Y3 P2 (= none)
X5 Y0 P1 (= none)
X7 Y1 P1 (= none)
G5.3 (= spline from X0 Y0 to X7 Y1 length 8.5952)
(order 3 without L; P alone on the first line is the weight of the first point)
G0 X0 Y0
G5.2 P2 (= none)
X1 Y2 P1
G5.2 X3 Y3 P1
X5 Y0 P1
G5.3 (= spline from X0 Y0 to X5 Y0 length 7.3801)
(G5.3 ends the motion mode)
X1 Y1 (= rapid to X1 Y1 | ! CH813 "no motion code is active")
(in G91 all control points count from where the tool stands)
G0 X0 Y0
G91 G5.2 X1 Y2 P1
X3 Y3 P1
G5.3 (= spline to X3 Y3 length 4.31995)
G90
(inches)
G20 G0 X0 Y0
G5 I0 J.3 P0 Q-.3 X.1 Y.1 F40 (= spline length 8.46063)
M2
