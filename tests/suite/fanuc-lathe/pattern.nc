(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(The whole contour three times, 6 mm and 4 mm nearer in all.)
G21 G18 G40 G99 G97 S800 M3
T0101
G0 X62. Z2.
G73 U6. W4. R3
G73 P10 Q50 U.6 W.2 F.2 (= rapid to X74.6 Z6.2 | rapid to X32.6 Z6.2 | rapid to X68.6 Z4.2 | rapid to X26.6 Z4.2 | rapid to X62.6 Z2.2 | rapid to X20.6 Z2.2 | rapid to X62 Z2)
N10 G0 X20.
G1 Z-20. (= line to X32.6 Z-15.8 | line to X26.6 Z-17.8 | line to X20.6 Z-19.8)
X40. Z-35. (= line to X52.6 Z-30.8 | line to X46.6 Z-32.8 | line to X40.6 Z-34.8)
Z-50. (= line to X52.6 Z-45.8 | line to X46.6 Z-47.8 | line to X40.6 Z-49.8)
N50 X62. (= line to X74.6 Z-45.8 | line to X68.6 Z-47.8 | line to X62.6 Z-49.8)
M30
