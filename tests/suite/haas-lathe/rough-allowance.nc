(machine: haas-lathe)
(set: settings.units="mm")
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(set: settings."Setting 73"="1 mm")
(I and K: a pass along the contour leaves them beside the allowance, and a second one leaves the allowance alone.)
G21 G18 G40 G99
T101
G97 S800 M03
G0 X40. Z2.
G71 P10 Q20 U.4 W.1 I.5 K.3 D5. F.3 (= rapid to X41.4 Z2.4 | rapid to X30 Z2.4 | line to X30 Z-19.6 | rapid to X32 Z-18.6 | rapid to X32 Z2.4 | rapid to X21.4 Z2.4 | rapid to X40.4 Z2.1 | rapid to X20.4 Z2.1 | rapid to X40 Z2)
N10 G0 X20.
G1 Z-20. (= line to X21.4 Z-19.6 | line to X20.4 Z-19.9 | line to X20.4 Z-20)
N20 X40. (= line to X41.4 Z-19.6 | line to X40.4 Z-19.9 | line to X40.4 Z-20)
(Without depth, and without P and Q.)
G71 P10 Q20 U.4 (= rapid to X40.4 Z2 | rapid to X30 Z2 | line to X30 Z-20 | rapid to X32 Z-19 | rapid to X32 Z2 | rapid to X20.4 Z2 | rapid to X40 Z2)
G71 U2. R1. (= ! CH308 "P and Q")
M30
