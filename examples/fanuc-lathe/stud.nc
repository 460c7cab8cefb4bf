%
O2205 (STUD M20 X 2.5, BOTH DIAMETERS)
(machine: fanuc-lathe)
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.8 mm")
(set: tools.1.tip=3)
(set: tools.3.offset.X="-103 mm")
(set: tools.3.offset.Z="-53 mm")
(set: tools.3.nose_radius="0.4 mm")
(set: tools.3.tip=3)
(set: tools.7.offset.X="-107 mm")
(set: tools.7.offset.Z="-57 mm")
G21 G18 G40 G80 G99
T0101
G50 S3000
G96 S200 M03
G0 X32. Z2. M08
G71 U2. R0.5
G71 P100 Q110 U0.5 W0.1 F0.25
N100 G0 G42 X14.
G1 Z0 F0.12
X19.8 Z-2.9
Z-40.
X17. Z-41.4
Z-45.
G2 X23. Z-48. R3.
G1 X26. K-1.
Z-60.
N110 G40 X32.
G0 X100. Z60.
T0303
G50 S3500
G96 S260 M03
G0 X32. Z2.
G70 P100 Q110
G0 X100. Z60.
T0707 (THREAD)
G97 S800 M03
G0 X24. Z6.
G76 P020060 Q80 R50
G76 X16.933 Z-41. P1534 Q400 F2.5
G0 X100. Z60. M09
G28 U0 W0
M30
%
