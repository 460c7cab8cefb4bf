(machine: haas-lathe)
(set: settings.units="mm")
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
G21 G18 G40 G99
T101
G97 S800 M3
M111
G0 X50. Z2.
G1 Z-10. F.2 (= line to Z-10)
M143 P500 (= none | ! CH312 "M143 is for the second spindle: how it takes the part, and what is cut there, is not followed")
G199 (= none)
G0 B-300. (= none)
M110
G14
G0 X60.
M30
