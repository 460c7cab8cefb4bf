(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(set: tools.2.offset.X="-90 mm")
(set: tools.2.offset.Z="-40 mm")
(set: tools.2.offset_wear.X="-0.2 mm")
(set: work_offsets.G54.X="0 mm")
(set: work_offsets.G54.Z="-300 mm")
G21 G18 G40 G99
G50 S3000
T0101
G97 S1000 M3
(X is a diameter, and U a change of it; a block may have U and Z.)
G0 X50. Z2. (= rapid to X50 Z2)
G1 Z-20. F.2 (= line to X50 Z-20 length 22.00 feed .2)
U10. Z-25. (= line to X60 Z-25)
W-5. (= line to X60 Z-30)
(R, I and K of arcs are radii.)
G2 X70. Z-35. R5. (= arc cw to X70 Z-35 center X70 Z-30 radius 5.00)
(An arc in force and no centre: a straight line.)
X72. (= line to X72 Z-35)
G1 X74.
G3 X80. Z-38. K-3. (= arc ccw to X80 Z-38 center X74 Z-38 radius 3.00)
G0 X100. Z5.
(G90 in a line of modes moves nothing.)
G18 G40 G80 G90 G99
G0 X90. (= rapid to X90 Z5)
(The offset of another tool acts at once: the slide stands, and the coordinates change.)
T0202
G0 X50. Z2. (= rapid from X80.2 Z-5 to X50 Z2)
G4 U1.5 (= dwell 1.5)
G28 U0 W0 (= rapid to X90.2 Z340)
M30
