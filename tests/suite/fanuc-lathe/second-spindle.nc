(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(The second spindle is noted once: by the axis that carries it, or by P of M3. X and Z go on.)
G21 G18 G40 G99
T0101
G97 S800 M3
G0 X50. Z2.
G1 Z-10. F.2 (= line to Z-10)
G0 X100. Z50.
G0 B-300. (= none | ! CH306 "no B axis, which carries the second spindle: its moves are left out")
G0 G53 B0. (= none)
G28 B0. (= none)
G0 X90. B-10. (= rapid to X90 Z50)
G98 G1 B-350. F100. (= none)
S500 M3 P13
M5
M30
