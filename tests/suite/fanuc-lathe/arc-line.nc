(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(A line after an arc without a code is usual on lathes; the code itself without R is not.)
G21 G18 G40 G99
T0101
G97 S800 M3
G0 X20. Z2.
G1 Z-10. F.2
G2 X24. Z-12. R2. (= arc cw radius 2)
X30. (= line to X30)
G3 X34. Z-14. (= line to X34 Z-14 | ! CH405 "straight line")
M30
