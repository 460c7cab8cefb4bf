%
O2209 (THE SAME HABITS IN G CODE SYSTEM B)
(machine: fanuc-lathe)
(set: settings."No. 3401"="B")
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.8 mm")
(set: tools.1.tip=3)
(set: tools.7.offset.X="-107 mm")
(set: tools.7.offset.Z="-57 mm")
G21 G18 G40 G80
T0101
G92 S2500
G96 S180 M03
G95 F0.25
G90 G0 X42. Z2. M08
G77 X38. Z-30.
X36.
X34.
G0 X60. Z20.
T0707
G97 S600 M03
G0 X38. Z5.
G78 X33.2 Z-20. F1.5
X32.6
X32.2
X32.16
G0 X60. Z20. M09
G28 X60. Z20.
M30
%
