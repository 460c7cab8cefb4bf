(machine: mitsubishi-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(As on Fanuc lathes; H0 leaves pockets, H1 cuts them, A names a program that is not followed.)
G21 G18 G40 G99 G97 S800 M3
T0101
G0 X52. Z2.
G71 U4. R.5
G71 P10 Q20 U0 W0 H1 F.2 (= rapid to X44 Z2 | line to X44 Z-20 | line to X52 Z-20 | rapid to X53 Z-20 | rapid to X53 Z2 | rapid to X40 Z2 | line to X40 Z-20 | line to X44 Z-20 | rapid to X45 Z-20 | rapid to X45 Z2 | rapid to X40 Z2 | rapid to X52 Z2)
N10 G0 X40.
G1 Z-20. (= line to X40 Z-20)
N20 X52. (= line to X52 Z-20)
G71 P30 Q40 U0 W0 H0 F.2 (= rapid to X44 Z2 | line to X44 Z-20 | rapid to X45 Z-19.5 | rapid to X45 Z2 | rapid to X40 Z2 | rapid to X52 Z2)
N30 G0 X40. Z2.
G1 Z-20. (= line to X40 Z-20)
N40 X52. (= line to X52 Z-20)
G71 P30 Q40 U0 A100 (= ! CH312 "program that holds the contour")
G71 P10 U0 (= ! CH308 "P and Q")
(A thread pass, and one along Z.)
G0 X28. Z6.
G92 X23.2 Z-25. F3. (= rapid to X23.2 Z6 | line to X23.2 Z-22 | line to X28 Z-24.4 | rapid to X28 Z-25 | rapid to X28 Z6)
G90 X20. Z-10. F.2 (= rapid to X20 Z6 | line to X20 Z-10 | line to X28 Z-10 | rapid to X28 Z6)
M30
