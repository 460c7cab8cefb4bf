%
O503 (DISC, FACED AND GROOVED)
(machine: mitsubishi-lathe)
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.8 mm")
(set: tools.1.tip=3)
(set: tools.4.offset.X="-104 mm")
(set: tools.4.offset.Z="-54 mm")
G21 G18 G40 G80 G99
T0101
G50 S1500
G96 S220 M3
G0 X104. Z2. M8
G94 X20. Z-1.5 F0.25
Z-3.
Z-4.
G0 X150. Z60.
T0404
G97 S500 M3
G0 X104. Z-15.
G75 R0.3
G75 X90. Z-19. P2000 Q2500 F0.08
G0 X150. Z60. M9
G28 U0 W0
M30
%
