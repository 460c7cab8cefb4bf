(machine: fanuc-30i)
(Mirror, scaling, rotation, polar coordinates: places are those of the work coordinate system.)
G21 G17 G90 G94 S500 M3
G0 X0 Y0 Z0 (= rapid to X0 Y0 Z0)
(A rotation about a point; cancelled, the words count as before.)
G68 X10. Y5. R30.
G1 X20. Y5. F100. (= line to X18.660254 Y10)
G69
X20. Y5. (= line to X20 Y5)
(G91 goes in the turned direction; the centre plays no part until an absolute word.)
G0 X10. Y0 (= rapid to X10 Y0)
G68 X0 Y0 R90.
G91 X10. (= rapid to X10 Y10)
G90 X20. Y0 (= rapid to X0 Y20)
G69
(The angle in G91 is absolute: No. 5400 RIN 0.)
G90 G68 X0 Y0 R30.
G91 G68 X0 Y0 R15.
G90 G0 X10. Y0 (= rapid to X9.659258 Y2.588190)
G69
(Without a centre about the present place.)
G0 X10. Y0
G68 R90.
X20. Y0 (= rapid to X10 Y10)
G69
(Unequal factors: ends by their own, R by the larger.)
G0 X0 Y100.
G51 X0 Y0 Z0 I2. J1. K1.
G2 X100. Y0 R100. F100. (= arc cw to X200 Y0 center X25.838015 Y-98.323970 radius 200.00)
G50
(The same by its centre: the radii are 100 and 200.)
G0 X0 Y100.
G51 X0 Y0 Z0 I2. J1. K1.
G2 X100. Y0 I0 J-100. (= ! CH401 "radius 100 mm at the start, 200 mm at the end")
G50
(A mirror turns G2 and G41 round.)
G0 X20. Y0
G51.1 X50.
G0 X20. Y10. (= rapid to X80 Y10)
G91 G0 X10. (= rapid to X70)
G90 G2 X40. Y10. I5. J0 (= arc ccw to X60 Y10 center X65 Y10 radius 5.00 sweep 180.00)
G50.1 X0
(Mirror, scaling and rotation: each centre goes through the frames inside it.)
G0 X0 Y0
G51.1 X5.
G51 X10. Y0 P2.
G68 X20. Y10. R90.
G0 X30. Y10. (= rapid to X-20 Y40)
G69
G50
G50.1 X0
(Unequal scaling, then rotation: a rotation of the scaled place.)
G0 X0 Y0
G51 X0 Y0 I2. J1.
G68 X0 Y0 R30.
X10. Y5. (= rapid to X14.820508 Y14.330127)
G69
G50
(Polar: a radius and an angle; in G91 the angle is added.)
G0 X0 Y0
G16
G90 G1 X100. Y30. F100. (= line to X86.602540 Y50)
G91 Y120. (= line to X-86.602540 Y50)
G90 G15
(P without a point counts in 0.001.)
G0 X0 Y0
G51 X0 Y0 P2000
X10. Y0 (= rapid to X20 Y0)
G50
G51 X0 Y0 P0 (= none | ! CH430)
(A cycle in a rotation: places turn; a scaled one: levels are scaled, steps are not.)
G0 X0 Y0 Z10. (= rapid to Z10)
G68 X0 Y0 R90.
G81 X10. Y0 Z-5. R2. F100. (= rapid to X0 Y10 | rapid to Z2 | line to Z-5 | rapid to Z10)
G80
G69
G51 X0 Y0 Z0 P2.
G83 X20. Y0 Z-4. R1. Q4. (= rapid to X40 Y0 | rapid to Z2 | line to Z-2 | rapid to Z2 | rapid to Z-1 | line to Z-6 | rapid to Z2 | rapid to Z-5 | line to Z-8 | rapid to Z10 | ! CH441 "scaled by 2")
G80
G50
(What does not go together.)
G68 X0 Y0 R10.
G18 (= none | ! CH432)
G2 X10. Z0 I5. K0 (= ! CH432)
G17
G28 Z10. (= ! CH433)
G69
M30
