(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(set: settings."No. 3403#5"=1)
G21 G18 G40 G99
T0101
G97 S800 M3
G0 X20. Z2.
G1 Z-10. F.2
G2 X24. Z-12. R2. (= arc cw radius 2)
X30. (= line to X30 | ! CH405 "PS0022")
M30
