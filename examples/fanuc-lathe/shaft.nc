%
O2201 (SHAFT, BAR 62)
(machine: fanuc-lathe)
(set: tools.1.offset.X="-120 mm")
(set: tools.1.offset.Z="-60 mm")
(set: tools.3.offset.X="-122 mm")
(set: tools.3.offset.Z="-61 mm")
(set: tools.3.nose_radius="0.4 mm")
(set: tools.3.tip=3)
(set: tools.5.offset.X="-118 mm")
(set: tools.5.offset.Z="-58 mm")
(set: tools.7.offset.X="-119 mm")
(set: tools.7.offset.Z="-59 mm")
G21 G18 G40 G97 G99
(T1 FACE AND ROUGH, CNMG 0.8)
G28 U0 W0
T0101
G50 S2500
G96 S220 M3
G0 X66. Z0.1 M8
G1 X-1.6 F0.2
G0 X62. Z2.
G71 U2.5 R1.
G71 P100 Q160 U0.6 W0.1 F0.3
N100 G0 G42 X16.
G1 Z0 F0.1
X23.8 Z-4.
Z-30.
X34. ,R3.
Z-45. ,R5.
N160 G40 X62.
G0 X100. Z50.
(T3 FINISH)
T0303
G50 S3500
G96 S280 M3
G0 X62. Z2.
G70 P100 Q160
G0 X100. Z50.
(T5 GROOVE, 3 WIDE)
T0505
G97 S900 M3
G0 X38. Z-27.
G75 R0.5
G75 X20. Z-30. P1500 Q2500 F0.08
G0 X100. Z50.
(T7 THREAD M24 X 3)
T0707
G97 S700 M3
G0 X28. Z6.
G76 P020560 Q100 R0.05
G76 X20.32 Z-26. P1840 Q500 F3.
G28 U0 W0 M9
M5
M30
%
