(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(Type II: the first block names X and Z, and pockets are cut.)
G21 G18 G40 G99 G97 S800 M3
T0101
G0 X52. Z2.
G71 U4. R.5
G71 P110 Q150 U0 W0 F.2 (= rapid to X44 Z2 | line to X44 Z-40 | line to X52 Z-40 | rapid to X53 Z-40 | rapid to X53 Z2 | rapid to X36 Z2 | line to X36 Z-40 | line to X44 Z-40 | rapid to X45 Z-40 | rapid to X45 Z2 | rapid to X30 Z2 | line to X30 Z-10 | line to X28 Z-11 | line to X28 Z-29 | line to X30 Z-30 | line to X30 Z-40 | line to X36 Z-40 | rapid to X37 Z-40 | rapid to X37 Z-11 | rapid to X28 Z-11 | line to X20 Z-15 | line to X20 Z-25 | line to X28 Z-29 | rapid to X29 Z-29 | rapid to X31 Z-29 | rapid to X31 Z2 | rapid to X30 Z2 | rapid to X52 Z2)
N110 G0 X30. W0
G1 Z-10. (= line to X30 Z-10)
X20. Z-15. (= line to X20 Z-15)
Z-25. (= line to X20 Z-25)
X30. Z-30. (= line to X30 Z-30)
Z-40. (= line to X30 Z-40)
N150 X52. (= line to X52 Z-40)
(Along X.)
G0 X62. Z2.
G72 W3. R1.
G72 P210 Q250 U.4 W.2 (= rapid to X62.4 Z2.2 | rapid to X62.4 Z-0.8 | line to X20.4 Z-0.8 | rapid to X22.4 Z0.2 | rapid to X62.4 Z0.2 | rapid to X62.4 Z-3.8 | line to X20.4 Z-3.8 | rapid to X22.4 Z-2.8 | rapid to X62.4 Z-2.8 | rapid to X62.4 Z-6.8 | line to X23.066667 Z-6.8 | rapid to X25.066667 Z-5.8 | rapid to X62.4 Z-5.8 | rapid to X62.4 Z-9.8 | line to X27.066667 Z-9.8 | rapid to X29.066667 Z-8.8 | rapid to X62.4 Z-8.8 | rapid to X62.4 Z-12.8 | line to X31.066667 Z-12.8 | rapid to X33.066667 Z-11.8 | rapid to X62.4 Z-11.8 | rapid to X62.4 Z-15.8 | line to X35.066667 Z-15.8 | rapid to X37.066667 Z-14.8 | rapid to X62.4 Z-14.8 | rapid to X62.4 Z-18.8 | line to X39.066667 Z-18.8 | rapid to X41.066667 Z-17.8 | rapid to X62.4 Z-17.8 | rapid to X62.4 Z-19.8 | rapid to X62 Z2)
N210 G0 Z-20.
G1 X40. (= line to X40.4 Z-19.8)
X20. Z-5. (= line to X20.4 Z-4.8)
N250 Z2. (= line to X20.4 Z2.2)
M30
