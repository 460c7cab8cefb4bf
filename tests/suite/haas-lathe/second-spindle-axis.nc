(machine: haas-lathe)
(set: settings.units="mm")
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(B, which the machine file does not have, carries the second spindle: a note, and X and Z go on.)
G21 G18 G40 G99
T101
G97 S800 M3
G53 G0 B0. (= none | ! CH306 "no B axis, which carries the second spindle")
G0 B1.27 (= none)
G0 X50. Z2. B-3. (= rapid to X50 Z2)
G1 Z-10. F.2 (= line to Z-10)
G28 B0. (= none)
M30
