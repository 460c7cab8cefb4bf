(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(M3 with the P of the spindle, of the live tool and of the second spindle: the path of X and Z goes on.)
G21 G18 G40 G99
T0101
G97 S800
M03 P11
G0 X50. Z2.
G1 Z-10. F.2 (= line to Z-10)
M5 P11
S500 M03 P12
M5 P12
S500 M3 P13 (= ! CH306 "P13 names the second spindle")
G0 A-5. (= none)
G1 Z-12. (= line to Z-12)
M30
