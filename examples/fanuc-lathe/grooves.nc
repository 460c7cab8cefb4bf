%
O2206 (PULLEY: GROOVES AND A FACE GROOVE)
(machine: fanuc-lathe)
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.8 mm")
(set: tools.1.tip=3)
(set: tools.4.offset.X="-104 mm")
(set: tools.4.offset.Z="-54 mm")
(set: tools.8.offset.X="-108 mm")
(set: tools.8.offset.Z="-58 mm")
(set: tools.8.nose_radius="0.2 mm")
(set: tools.8.tip=7)
G21 G18 G40 G80 G99
T0101
G50 S2000
G96 S200 M03
G0 X104. Z0 M08
G1 X-1.6 F0.2
G0 X98. Z2.
G1 Z-60. F0.25
X104.
G0 X150. Z50.
T0404 (GROOVE 4 WIDE)
G50 S1500
G96 S120 M03
G0 X102. Z-14.
G75 R0.3
G75 X80. Z-20. P2500 Q3000 F0.08
G0 Z-34.
G75 X84. P2000 F0.08
G0 X150. Z50.
T0808 (FACE GROOVE)
G50 S1500
G96 S100 M03
G0 X70. Z2.
G74 R0.3
G74 X60. Z-5. P1500 Q1500 F0.06
G0 X150. Z50. M09
G28 U0 W0
M30
%
