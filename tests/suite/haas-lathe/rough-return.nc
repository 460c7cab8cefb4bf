(machine: haas-lathe)
(set: settings.units="mm")
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(set: settings."Setting 73"="1 mm")
(The last block of a contour brings the tool back in Z at the diameter of the start: it is outside the stock and no part of the shape. G70 cuts the contour as it is written.)
G21 G18 G40 G99
T101
G97 S800 M03
G0 X40. Z2.
G71 P10 Q20 U.4 W.1 D5. F.3 (= rapid to X40.4 Z2.1 | rapid to X30 Z2.1 | line to X30 Z-19.9 | rapid to X32 Z-18.9 | rapid to X32 Z2.1 | rapid to X20.4 Z2.1 | rapid to X40 Z2)
N10 G0 X20. (= rapid to X20 Z2)
G1 Z-20. (= line to X20.4 Z-19.9 | line to X20 Z-20)
X40. (= line to X40.4 Z-19.9 | line to X40 Z-20)
N20 G0 Z2. (= rapid to X40 Z2)
G70 P10 Q20
(Further out, and with two blocks back.)
G71 P30 Q40 U.4 W.1 D5. F.3 (= rapid to X40.4 Z2.1 | rapid to X30 Z2.1 | line to X30 Z-19.9 | rapid to X32 Z-18.9 | rapid to X32 Z2.1 | rapid to X20.4 Z2.1 | rapid to X40 Z2)
N30 G0 X20.
G1 Z-20. (= line to X20.4 Z-19.9)
X44. (= line to X44.4 Z-19.9)
Z-5.
N40 G40 Z2.
(In a bore the outside is at smaller diameters.)
G0 X10. Z2.
G71 P50 Q60 U-.4 W.1 D5. F.3 (= rapid to X9.6 Z2.1 | rapid to X20 Z2.1 | line to X20 Z-19.9 | rapid to X18 Z-18.9 | rapid to X18 Z2.1 | rapid to X29.6 Z2.1 | rapid to X10 Z2)
N50 G0 X30.
G1 Z-20. (= line to X29.6 Z-19.9)
X10. (= line to X9.6 Z-19.9)
N60 Z2.
(Facing: the return is in X, in front of the part.)
G0 X40. Z2.
G72 P70 Q80 U.4 W.1 D5. F.3 (= rapid to X40.4 Z2.1 | rapid to Z-3 | line to X20.4 Z-3 | rapid to X22.4 Z-2 | rapid to X40.4 Z-2 | rapid to X40.4 Z-5.9 | rapid to X40 Z2)
N70 G0 Z-6.
G1 X20. (= line to X20.4 Z-5.9)
Z2. (= line to X20.4 Z2.1)
N80 G0 X40.
(Back at a diameter of the part: it is shape, and cannot be cut.)
G71 P90 Q95 U.4 W.1 D5. F.3 (= none)
N90 G0 X20.
G1 Z-20.
X30.
N95 Z2. (= ! CH303 "turns back in Z")
M30
