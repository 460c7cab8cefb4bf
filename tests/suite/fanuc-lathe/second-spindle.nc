(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(The second spindle is said once: by the axis that carries it, or by P of M3.)
G21 G18 G40 G99
T0101
G97 S800 M3
G0 X50. Z2.
G1 Z-10. F.2 (= line to Z-10)
G0 X100. Z50.
G0 B-300. (= none | ! CH312 "B is for the second spindle: how it takes the part, and what is cut there, is not followed")
G98 G1 B-350. F100. (= none)
S500 M3 P13
M5
M30
