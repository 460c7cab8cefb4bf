%
O2202 (DOWEL PIN, BAR 12, PARTED OFF)
(machine: fanuc-lathe)
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.4 mm")
(set: tools.1.tip=3)
(set: tools.4.offset.X="-104 mm")
(set: tools.4.offset.Z="-54 mm")
G21 G18 G40 G80 G99
G28 U0 W0
T0101 (FACE AND TURN, DCMT 0.4)
G50 S4000
G96 S180 M03
G0 X14. Z0.1 M08
G1 X-0.8 F0.12
G0 X11. Z1.
G42 G1 X8. Z0 F0.2
X10. Z-1. F0.1
Z-32.
G40 X13.
G0 X60. Z40.
T0404 (PART OFF, 2.5 WIDE)
G50 S2500
G96 S90 M03
G0 X14. Z-32.5
G1 X9. F0.06
G0 X10.5
Z-31.5
G1 X8.5 Z-32.5 F0.05
X-0.5
G0 X14.
G97 S500
M09
G28 U0 W0
M05
M30
%
