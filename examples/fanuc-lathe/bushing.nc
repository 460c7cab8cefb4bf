%
O2204 (BUSHING WITH INSIDE THREAD M30 X 1.5)
(machine: fanuc-lathe)
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.8 mm")
(set: tools.1.tip=3)
(set: tools.5.offset.X="-105 mm")
(set: tools.5.offset.Z="-55 mm")
(set: tools.6.offset.X="-106 mm")
(set: tools.6.offset.Z="-56 mm")
G21 G18 G40 G80 G99
T0505 (DRILL 26 ON CENTRE)
G97 S600 M03
G0 X0 Z5. M08
G83 Z-48. R-3. Q8000 F0.15
G80
G0 X200. Z100.
T0101 (OD)
G50 S2500
G96 S200 M03
G0 X52. Z2.
G90 X48. Z-45. F0.25
X46. Z-30.
X44.
G0 X200. Z100.
T0606 (THREAD INSIDE)
G97 S700 M03
G0 X26. Z5.
G92 X28.8 Z-25. F1.5
X29.2
X29.6
X29.8
X30.
X30.
G0 Z20. M09
G28 U0 W0
M30
%
