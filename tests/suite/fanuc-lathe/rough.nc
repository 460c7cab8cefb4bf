(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(Roughing outside, type I: levels 2.5 below each other, measured on the radius, from the start with the allowance.)
G21 G18 G40 G99 G97 S800 M3
T0101
G0 X62. Z2.
G71 U2.5 R1.
G71 P10 Q50 U.6 W.2 F.3 (= rapid to X62.6 Z2.2 | rapid to X57.6 Z2.2 | line to X57.6 Z-49.8 | rapid to X59.6 Z-48.8 | rapid to X59.6 Z2.2 | rapid to X52.6 Z2.2 | line to X52.6 Z-49.8 | rapid to X54.6 Z-48.8 | rapid to X54.6 Z2.2 | rapid to X47.6 Z2.2 | line to X47.6 Z-49.8 | rapid to X49.6 Z-48.8 | rapid to X49.6 Z2.2 | rapid to X42.6 Z2.2 | line to X42.6 Z-49.8 | rapid to X44.6 Z-48.8 | rapid to X44.6 Z2.2 | rapid to X37.6 Z2.2 | line to X37.6 Z-32.55 | rapid to X39.6 Z-31.55 | rapid to X39.6 Z2.2 | rapid to X32.6 Z2.2 | line to X32.6 Z-28.8 | rapid to X34.6 Z-27.8 | rapid to X34.6 Z2.2 | rapid to X27.6 Z2.2 | line to X27.6 Z-25.05 | rapid to X29.6 Z-24.05 | rapid to X29.6 Z2.2 | rapid to X22.6 Z2.2 | line to X22.6 Z-21.3 | rapid to X24.6 Z-20.3 | rapid to X24.6 Z2.2 | rapid to X20.6 Z2.2 | rapid to X62 Z2)
N10 G0 X20. (= rapid to X20 Z2)
G1 Z-20. (= line to X20.6 Z-19.8 | line to X20 Z-20)
X40. Z-35. (= line to X40.6 Z-34.8 | line to X40 Z-35)
Z-50. (= line to X40.6 Z-49.8 | line to X40 Z-50)
N50 X62. (= line to X62.6 Z-49.8 | line to X62 Z-50)
(After the contour back to the start, and on behind this block.)
G70 P10 Q50 (= rapid to X62 Z2)
(Three passes of the whole contour, 6 mm and 4 mm nearer in all: the last leaves the allowance.)
M30
