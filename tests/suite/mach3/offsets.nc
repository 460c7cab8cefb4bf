(machine: mach3-mill)
(set: work_offsets.G54.X="100 mm")
(set: work_offsets.G59.X="200 mm")
(set: work_offsets."G59 P7".X="300 mm")
(set: tools.1.length="50 mm")
(set: tools.1.diameter="6 mm")
(G59 counts all work offsets: P1 is G54, P6 is G59 itself. G10 L2 counts alike.)
G21 G90 G17
G0 X0 Y0 Z0
G59
G53 G0 X200
X0 (= rapid to X0)
G59 P7
X0 (= rapid to X0)
G59 P1
X1 (= rapid to X1)
#10=#5220
X#10 (= rapid to X1)
G59 P300 (= none | ! CH303 "P300")
G10 L2 P7 X10 Y20
G59 P7
X0 (= rapid to X0)
G54
T1 M6
G43 H1 Z10 (= rapid to Z10)
G49
G43 Z10 (= ! CH312 "without H")
G49
S1000 M3 F300
G0 X0 Y0
(The compensated path: the tool centre is 3 mm to the left.)
G41 D1 G1 X20 Y0 (= line | ! CH531 | ! CH611 "no length offset is in force")
X40
G40 X60 (= line | ! CH531)
G42 P3 X80 (= ! CH312 "with P, the size")
G40 X100
M30
