(machine: fanuc-lathe-c)
(set: tools.1.offset.X="0 mm")
(set: tools.1.offset.Z="0 mm")
(set: work_offsets.G54.Z="-100 mm")
(set: work_offsets."G54.1 P3".Z="-300 mm")
(G54 with P, and C by H: G28 H0 sends C home alone.)
G21 G18 G40 G99
T0101
G97 S800
G54 P3
G0 X50. Z2. C0.
G53 Z0. (= rapid to X50 Z300)
H90. (= rapid to X50 Z300 C90)
G28 H0. (= rapid to X50 Z300 C0)
G28 H0 (= rapid)
M30
