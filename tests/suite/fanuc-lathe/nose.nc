(machine: fanuc-lathe)
(set: tools.1.nose_radius="0.8 mm")
(set: tools.1.tip=3)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(show: path)
(What the control moves is the imaginary tip: 0.6111 is r times 1 - tan a/2 of a slope of 1 in 2.)
G21 G18 G40 G99 G97 S800 M3
T0101
G0 X30. Z5.
G42 G1 X20. Z2. F.2 (= line to X20 Z1.2)
Z-20. (= line to X20 Z-20.611146)
X40. Z-40. (= line to X40 Z-40.611146)
Z-60. (= line to X40 Z-60.8)
G40 X50. (= line to X50 Z-60)
G0 X4. Z3.
(Arcs: the corner's gets larger by the nose, the fillet's smaller.)
G42 G1 X10. Z0
X16. (= line to X14.4 Z0)
G3 X20. Z-2. K-2. (= arc ccw to X20 Z-2.8 radius 2.80)
G1 Z-20. (= line to X20 Z-20.8)
G2 X30. Z-25. I5. (= arc cw to X28.4 Z-25 radius 4.20)
G1 X50. (= line to X48.4 Z-25)
G40 X52.
M30
