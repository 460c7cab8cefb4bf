%
O505 (BORE AND THREAD INSIDE, SUBPROGRAM)
(machine: mitsubishi-lathe)
(set: tools.2.offset.X="-102 mm")
(set: tools.2.offset.Z="-52 mm")
(set: tools.2.nose_radius="0.8 mm")
(set: tools.2.tip=2)
(set: tools.6.offset.X="-106 mm")
(set: tools.6.offset.Z="-56 mm")
G21 G18 G40 G80 G99
T0202
G50 S2000
G96 S160 M3
G0 X20. Z2. M8
G71 U1. R0.5
G71 P10 Q20 U-0.4 W0.1 F0.2
N10 G0 X32.
G1 Z0 F0.12
X28.5 Z-1.75
Z-22.
N20 X20.
G70 P10 Q20
G0 Z50.
T0606
G97 S600 M3
G0 X25. Z5.
M98 P600
G0 Z50. M9
G28 U0 W0
M30
O600
G92 X28.9 Z-18. F1.5
X29.4
X29.8
X30.
M99
%
