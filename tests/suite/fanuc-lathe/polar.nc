(machine: fanuc-lathe-c)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(set: work_offsets.G54.X="-200 mm")
(set: work_offsets.G54.Z="-300 mm")
(set: work_offsets.G54.C="0 deg")
G21 G18 G40 G80 G98 G97 S1000 M3
T0101
G54
G0 X60. Z5. C0
(X is a diameter, C a length on the face: the path is in X and Y.)
G12.1
G1 X40. C0 F500. (= line from X60 Y0 to X40 Y0 length 10.00 feed 500)
C10. (= line to X40 Y10 length 10.00)
X-40. (= line to X-40 Y10 length 40.00)
C-10. (= line to X-40 Y-10)
X40. (= line to X40 Y-10)
C0 (= line to X40 Y0)
H5. (= line to X40 Y5)
U-4. (= line to X36 Y5)
X40. C0 (= line to X40 Y0)
(Arcs: I along X and J across, on the radius, or R.)
G3 X20. C10. I-10. J0 (= arc ccw to X20 Y10 center X20 Y0 plane xy radius 10.00 sweep 90.00)
G2 X0 C20. R10. (= arc cw to X0 Y20 radius 10.00 sweep 90.00)
(A dwell, exact stop and modal codes may come.)
G4 X.5 (= dwell .5)
(What may not: rapids, work offsets, other planes, cycles, tools.)
G0 X60. (= rapid to X60 Y20 | ! CH442 "G0 in polar interpolation" "PS0146")
Z3. (= rapid to Z3 | ! CH442 "a rapid in polar interpolation" "PS0146")
G1 Z5. (= line to Z5)
G54 X50. (= none | ! CH442 "G54" "PS0146")
G28 U0 (= none | ! CH442 "G28")
G18 (= none | ! CH442 "G18")
G92 X20. Z-20. F2. (= none | ! CH442 "G92")
T0202 (= none | ! CH442 "a tool or its offset")
G7.1 C20. (= none | ! CH443 "while polar interpolation is active")
G12.1 (= none | ! CH443)
X60. C0 (= line to X60 Y0)
(The axes themselves again: C has gone once around the centre, with the arc.)
G13.1
G0 X70. C360. (= rapid from X60 C360 to X70 C360)
(Compensation begins and ends inside.)
G42 X60.
G12.1 (= none | ! CH443 "begins while cutter compensation is on" "PS0145")
G13.1 (= none | ! CH443 "ends while cutter compensation is on")
G40 X80.
M30
