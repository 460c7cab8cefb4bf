%
O2207 (CAST HUB: G73 FOLLOWS THE CASTING)
(machine: fanuc-lathe)
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.8 mm")
(set: tools.1.tip=3)
(set: tools.3.offset.X="-103 mm")
(set: tools.3.offset.Z="-53 mm")
(set: tools.3.nose_radius="0.8 mm")
(set: tools.3.tip=3)
G21 G18 G40 G80 G99
T0101
G50 S1500
G96 S160 M03
G0 X92. Z4. M08
G73 U4. W3. R3
G73 P10 Q20 U0.6 W0.2 F0.25
N10 G0 X40. Z1.
G1 Z-12. F0.15
G2 X56. Z-20. R8.
G1 X70. Z-32.
N20 X84. Z-36.
T0303
G96 S200 M03
G70 P10 Q20
G0 X150. Z80. M09
G28 U0 W0
M30
%
