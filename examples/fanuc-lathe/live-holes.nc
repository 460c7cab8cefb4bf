%
O2210 (FOUR CROSS HOLES AND A BOLT CIRCLE, LIVE TOOLS)
(machine: fanuc-lathe-c)
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.8 mm")
(set: tools.1.tip=3)
(set: tools.9.offset.X="-109 mm")
(set: tools.9.offset.Z="-59 mm")
(set: tools.11.offset.X="-111 mm")
(set: tools.11.offset.Z="-61 mm")
G21 G18 G40 G80 G99
T0101
G50 S2000
G96 S180 M03
G0 X64. Z0.1 M08
G1 X-1.6 F0.2
G0 X60. Z2.
G1 Z-40. F0.25
X64.
G0 X150. Z80. M05
(C AXIS ON)
G28 H0
T0909 (LIVE DRILL 6 ALONG Z)
G98
G97 S1500 M03
G0 X40. Z5. C0
G83 Z-12. R-3. Q4000 F150.
H90.
H90.
H90.
G80
G0 Z50.
T1111 (LIVE DRILL 5 ALONG X)
G0 X66. Z-20. C45.
G87 X40. R-2. Q3000 F120.
H180.
G80
G0 X150. Z80. M09
G99
G28 U0 W0
G28 H0
M30
%
