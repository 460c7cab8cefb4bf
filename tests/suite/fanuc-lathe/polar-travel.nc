(machine: fanuc-lathe-c)
(set: tools.1.offset.X="0 mm")
(set: tools.1.offset.Z="0 mm")
(set: work_offsets.G54.X="-200 mm")
(set: work_offsets.G54.Z="-300 mm")
(set: work_offsets.G54.C="0 deg")
(set: axes.X.travel=["-176 mm", "-100 mm"])
(set: axes.C.travel=["-40 deg", "400 deg"])
(The axes themselves, in the middle of moves: X comes to 20 mm where the line is nearest, with travel from 24 mm on.)
G21 G18 G40 G80 G98 G97 S1000 M3
T0101
G54
G0 X60. Z5. C0
G12.1
G1 X40. C0 F100.
C10. (= line to X40 Y10)
X-40. (= line to X-40 Y10 | ! CH601 "X")
G13.1
G0 Z6.
(A circle of radius 10 next to the centre: C turns to 41.81 degrees on both sides.)
G0 X60. C0
G12.1
G1 X50. F100.
G3 I-10. J0 (= arc ccw | ! CH601 "C")
G13.1
M30
