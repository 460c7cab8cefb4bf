(machine: haas-lathe)
(set: settings.units="mm")
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(set: settings."Setting 73"="1 mm")
(All of a cycle is in one block. The levels begin at the start itself, 2.5 below each other on the radius.)
G21 G18 G40 G99
T101
G97 S800 M03
G0 X62. Z2.
G71 P10 Q50 U.6 W.2 D2.5 F.3 (= rapid to X62.6 Z2.2 | rapid to X57 Z2.2 | line to X57 Z-49.8 | rapid to X59 Z-48.8 | rapid to X59 Z2.2 | rapid to X52 Z2.2 | line to X52 Z-49.8 | rapid to X54 Z-48.8 | rapid to X54 Z2.2 | rapid to X47 Z2.2 | line to X47 Z-49.8 | rapid to X49 Z-48.8 | rapid to X49 Z2.2 | rapid to X42 Z2.2 | line to X42 Z-49.8 | rapid to X44 Z-48.8 | rapid to X44 Z2.2 | rapid to X37 Z2.2 | line to X37 Z-32.1 | rapid to X39 Z-31.1 | rapid to X39 Z2.2 | rapid to X32 Z2.2 | line to X32 Z-28.35 | rapid to X34 Z-27.35 | rapid to X34 Z2.2 | rapid to X27 Z2.2 | line to X27 Z-24.6 | rapid to X29 Z-23.6 | rapid to X29 Z2.2 | rapid to X22 Z2.2 | line to X22 Z-20.85 | rapid to X24 Z-19.85 | rapid to X24 Z2.2 | rapid to X20.6 Z2.2 | rapid to X62 Z2)
N10 G0 X20. (= rapid to X20 Z2)
G1 Z-20. (= line to X20.6 Z-19.8 | line to X20 Z-20)
X40. Z-35. (= line to X40.6 Z-34.8 | line to X40 Z-35)
Z-50. (= line to X40.6 Z-49.8 | line to X40 Z-50)
N50 X62. (= line to X62.6 Z-49.8 | line to X62 Z-50)
G70 P10 Q50 (= rapid to X62 Z2)
M30
