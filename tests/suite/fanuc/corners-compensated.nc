(machine: fanuc-30i)
(show: path)
(set: tools.1.diameter="10 mm")
(With compensation the rounding is part of the programmed contour: radius 3 outside is 8, 8 inside is 3.)
G21 G17 G90 G40
T1 M6
S1000 M3
G0 X-20. Y20.
F100.
G41 D1 G1 Y0. (= line to X-20 Y5)
X20. ,R3. (= line to X17 Y5 | arc cw to X25 Y-3 center X17 Y-3 radius 8.00)
Y-40. ,R8. (= line to X25 Y-32 | arc ccw to X28 Y-35 center X28 Y-32 radius 3.00)
(The chamfer lies on X + Y = 16, its offset on 16 + 5 root 2 = 23.071068.)
X60. ,C4. (= line to X58.071068 Y-35)
 (= line to X65 Y-41.928932)
Y-60. (= line to X65 Y-60)
G40 X80. (= line to X80 Y-60)
M30
