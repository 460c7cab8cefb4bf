%
O30002 (BEARING RING, BORE AND FACE GROOVE)
(machine: haas-lathe)
(set: settings.units="mm")
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.8 mm")
(set: tools.1.tip=3)
(set: tools.2.offset.X="-102 mm")
(set: tools.2.offset.Z="-52 mm")
(set: tools.2.nose_radius="0.8 mm")
(set: tools.2.tip=2)
(set: tools.6.offset.X="-106 mm")
(set: tools.6.offset.Z="-56 mm")
G21 G18 G40 G80 G99
T101
G50 S1500
G97 S600 M03
G00 X92. Z3. M08
G96 S200
G72 P10 Q20 D1.5 U0.4 W0.1 F0.25
N10 G00 Z-10.
G01 X70. F0.15
Z-4.
X60.
N20 Z2.
G70 P10 Q20
G53 G00 X0 Z0
T202
G50 S2000
G96 S160 M03
G00 X30. Z2.
G71 P30 Q40 D1.5 U-0.4 W0.1 F0.2
N30 G41 G00 X52.
G01 Z0 F0.12
X48. Z-2.
Z-15.
X40.
Z-25.
N40 G40 X30.
G70 P30 Q40
G00 Z10.
G53 G00 X0 Z0
T606 (FACE GROOVE)
G97 S700 M03
G00 X64. Z-2.
G74 X62. Z-8. I0.5 K1.5 F0.06
G53 G00 X0 M09
G53 G00 Z0
M30
%
