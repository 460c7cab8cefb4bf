(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(T0100 takes the offset away: the nose radius is 0.)
G21 G18 G40 G99
T0100
G97 S800 M3
G0 X20. Z2.
G42 G1 Z-10. F.2 (= line to X20 Z-10 | ! CH503 "no tool offset is active")
G40 X30. (= line to X30 Z-10)
M30
