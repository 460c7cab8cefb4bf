(machine: mitsubishi-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
G21 G18 G40 G99
T0101
G97 S800 M3
G0 X50. Z2.
G0 B-3. (= none | ! CH306 "no B axis")
G1 Z-10. F.2 (= line to Z-10)
M30
