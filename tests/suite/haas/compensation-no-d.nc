(machine: haas-vf2)
(set: settings.units="mm")
(set: tools.1.diameter="10 mm")
(show: path)
(No D anywhere: D0 is in force from power-on, and the tool runs on the contour.)
G21 G17 G90 G94 S1000 M3
G0 X0. Y0.
G1 F100.
G42 X10. (= line to X10 Y0 | ! CH503 "no D before this: the offset is 0")
Y10. (= line to X10 Y10)
X20. (= line to X20 Y10)
G40 X30. (= line to X30 Y10)
(D0 written is the same, and a note.)
G41 D0 Y20. (= line to X30 Y20 | ! CH503 "D0")
X40. (= line to X40 Y20)
G40 X50. (= line to X50 Y20)
(A D from before is in force without being written again.)
D1
G41 X60. (= line to X55 Y20)
Y50. (= line to X55 Y50)
G40 X30. (= line to X30 Y50)
M30
