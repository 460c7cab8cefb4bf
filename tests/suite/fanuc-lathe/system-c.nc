(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(set: settings."No. 3401"="C")
G71 G18 G40 G80
G92 S3000
T0101
G97 S800 M3
G95 F.25
G0 X66. Z2.
G20 X60. Z-40. (= rapid to X60 Z2 | line to X60 Z-40 | line to X66 Z-40 | rapid to X66 Z2)
G24 X20. Z-2. F.2 (= rapid to X66 Z-2 | line to X20 Z-2 | line to X20 Z2 | rapid to X66 Z2)
G0 X28. Z6.
G21 X23.2 Z-25. F3. (= rapid to X23.2 Z6 | line to X23.2 Z-22 | line to X28 Z-24.4 | rapid to X28 Z-25 | rapid to X28 Z6)
G0 X0 Z3.
G76 R1.
G76 Z-15. Q12000 F.15 (= line to X0 Z-9 | rapid to X0 Z-8 | line to X0 Z-15 | rapid to X0 Z3)
G0 X52. Z2.
G73 U4. R.5
G73 P10 Q20 U0 W0 F.2 (= rapid to X44 Z2 | line to X44 Z-20 | rapid to X45 Z-19.5 | rapid to X45 Z2 | rapid to X40 Z2 | rapid to X52 Z2)
N10 G0 X40. (= rapid to X40 Z2)
G1 Z-20. (= line to X40 Z-20 | line to X40 Z-20)
N20 X52. (= line to X52 Z-20 | line to X52 Z-20)
G72 P10 Q20 (= rapid to X52 Z2)
M30
