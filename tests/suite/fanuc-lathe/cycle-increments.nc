(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(Lengths of cycles in least increments, among numbers with points: the usual way of writing.)
G21 G18 G40 G99
T0101
G97 S800 M3
G0 X40. Z2.
G71 U5000 R1000
G71 P10 Q20 U400 W100 F.3 (= rapid to X40.4 Z2.1 | rapid to X30.4 Z2.1 | line to X30.4 Z-19.9 | rapid to X32.4 Z-18.9 | rapid to X32.4 Z2.1 | rapid to X20.4 Z2.1 | rapid to X40 Z2)
N10 G0 X20.
G1 Z-20. (= line to X20.4 Z-19.9)
N20 X40. (= line to X40.4 Z-19.9)
G75 R10
G75 X36. P2000 F.1 (= line to X36 Z2 | rapid to X40)
G74 R50
G74 Z-1. Q3000 F.1 (= line to Z-1 | rapid to Z2)
G76 P021060 Q30 R30
G0 X20. Z5.
G83 Z-8. R-3000 Q20000 F.1 (= rapid to Z2 | line to Z-8 | rapid to Z5)
G80
G90 X18. Z-5. R-50 F.2 (= rapid to X17.9 Z5 | line to X18 Z-5 | line to X20 Z-5 | rapid to X20 Z5)
G0 X40. Z2.
(A depth of 2 is a slip, and so is a position without a point.)
G71 U2 R10 (= none | ! CH305 "U2")
G0 X50 (= rapid | ! CH305 "X50")
M30
