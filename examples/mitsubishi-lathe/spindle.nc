%
O501 (SPINDLE NOSE, ROUGHED WITH A POCKET)
(machine: mitsubishi-lathe)
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.4 mm")
(set: tools.1.tip=3)
(set: tools.3.offset.X="-103 mm")
(set: tools.3.offset.Z="-53 mm")
(set: tools.3.nose_radius="0.4 mm")
(set: tools.3.tip=3)
G21 G18 G40 G80 G99
G28 U0 W0
T0101
G50 S2500
G96 S180 M3
G0 X62. Z2. M8
G71 U2. R0.5
G71 P10 Q20 U0.4 W0 H1 F0.25
N10 G0 X30. Z2.
G1 Z-15. F0.12
X24. Z-20.
Z-30.
X30. Z-36.
Z-50.
N20 X62.
T0303
G96 S240 M3
G70 P10 Q20
G0 X150. Z80. M9
G28 U0 W0
M30
%
