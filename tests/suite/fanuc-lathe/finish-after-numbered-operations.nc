(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(Operations are numbered with N as well: G70 cuts the contour of the roughing cycle, not the block of the same)
(number above it.)
N01 G21 G18 G40 G99 G97 S800 M3
T0101
G0 X44. Z2.
G71 U2. R.5
G71 P1 Q2 U0 W0 F.2 (= rapid to X40 Z2 | rapid to X44 Z2)
N1 G0 X40. (= rapid to X40 Z2)
N2 G1 Z-20. (= line to X40 Z-20 | line to X40 Z-20)
N02 (FINISH)
G70 P1 Q2 (= rapid to X44 Z2)
M30
