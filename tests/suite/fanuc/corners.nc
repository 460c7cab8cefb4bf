(machine: fanuc-30i)
(Roundings and chamfers at the end of a block. Corners: the moves are written to the corner itself.)
G21 G17 G90 G94 S1000 M3
G0 X0 Y0 Z0
(Lines: each loses the radius at a square corner, or the length of the chamfer.)
G1 X20. ,R5. F300. (= line to X15 Y0 | arc ccw to X20 Y5 center X15 Y5 radius 5.00 sweep 90.00 feed 300)
Y20. ,C3. (= line from X20 Y5 to X20 Y17 | line to X17 Y20)
X0. ,R4. F200. (= line from X17 Y20 to X4 Y20 feed 200 | arc ccw to X0 Y16 radius 4.00 feed 200)
Y10. (= line from X0 Y16 to X0 Y10)
(A line and the half circle about X10 Y10: the rounding is 6 from its centre, X = 10 - root 35. At its other)
(end 7 from the centre and 2 above the line, X = 10 + root 45.)
X5. ,R1. (= line to X4.083920 Y10 | arc ccw to X5.069934 Y10.833333 radius 1.00)
G2 X15. I5. ,R2. (= arc cw from X5.069934 Y10.833333 to X14.791574 Y11.428571 center X10 Y10 radius 5.00 sweep 153.80)
 (= arc ccw to X16.708204 Y10 radius 2.00)
G1 X25. (= line from X16.708204 Y10 to X25 Y10)
(Two arcs of 10: the rounding is 11 from both centres, root 71 from the middle between them.)
G3 X35. Y20. J10. ,R1. (= arc ccw to X34.961989 Y19.128920 radius 10.00 | arc cw to X35.871080 Y20.038011 radius 1.00)
G3 X45. Y30. J10. (= arc ccw from X35.871080 Y20.038011 to X45 Y30 radius 10.00)
(Zero asks for nothing; G91 counts from the corner itself.)
G1 X50. ,R0 (= line to X50 Y30)
G91 Y10. ,R2. (= line to X50 Y38 | arc cw to X52 Y40)
X10. ,C1. (= line to X59 Y40 | line to X60 Y39)
Y-20. (= line from X60 Y39 to X60 Y20)
(All of a move may go.)
X-10. ,R10. (= arc cw from X60 Y20 to X50 Y30 radius 10.00)
Y10. (= none)
G90 X50. Y40. (= line from X50 Y30 to Y40)
(In a rotation, mirrored and scaled.)
G0 X0 Y0
G68 X0 Y0 R90.
G1 X20. ,R5. (= line to X0 Y15 | arc ccw to X-5 Y20 radius 5.00)
Y10. (= line from X-5 Y20 to X-10 Y20)
G69
G0 X0 Y0
G51 X0 Y0 Z0 P2.
G1 X20. ,R5. (= line to X30 Y0 | arc ccw to X40 Y10 radius 10.00)
Y10. (= line to X40 Y20)
G50
(A dwell may stand between, and a line with a number or a comment.)
G0 X0 Y0
G1 X20. ,R5. (= line to X15 Y0 | arc ccw to X20 Y5)
G4 P100
N10
Y20. (= line from X20 Y5 to X20 Y20)
(Straight on within one degree: nothing.)
X10. ,R1. (= line to X10 Y20)
X0. Y20.1 (= line to X0 Y20.1)
(The other planes.)
G0 X0 Y0 Z0
G18 G1 Z20. ,R5. (= line to Z15 X0 | arc ccw plane zx to Z20 X5 radius 5.00)
X10. (= line from Z20 X5 to X10)
G19 Y20. ,C2. (= line to Y18 Z20 | line to Y20 Z18)
Z10. (= line from Y20 Z18 to Z10)
G17
M30
