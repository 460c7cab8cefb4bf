%
O502 (STUD M16, G76 IN TWO BLOCKS)
(machine: mitsubishi-lathe)
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.8 mm")
(set: tools.1.tip=3)
(set: tools.7.offset.X="-107 mm")
(set: tools.7.offset.Z="-57 mm")
G21 G18 G40 G80 G99
T0101
G50 S3000
G96 S180 M3
G0 X24. Z1. M8
G90 X20. Z-40. F0.25
X18.
X16.
G0 X100. Z50.
T0707
G97 S800 M3
G0 X20. Z5.
G76 P010060 Q50 R30
G76 X13.546 Z-30. P1227 Q350 F2.
G0 X100. Z50. M9
G28 U0 W0
M30
%
