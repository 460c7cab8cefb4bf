%
O2301 (BOLT, BAR 46, FIRST VERSION)
(machine: fanuc-lathe)
(set: tools.1.offset.X="-120 mm")
(set: tools.1.offset.Z="-60 mm")
(set: tools.3.offset.X="-122 mm")
(set: tools.3.offset.Z="-61 mm")
(set: tools.3.nose_radius="0.4 mm")
(set: tools.3.tip=3)
(set: tools.5.offset.X="-118 mm")
(set: tools.5.offset.Z="-58 mm")
G21 G18 G40 G97 G99
G28 U0 W0
(T1 FACE AND ROUGH, CNMG 120408)
T0101
G50 S2500
G96 S200 M3
G0 X50. Z0 M8
G1 X-1.6 F0.2
G0 X48. Z2.
G71 U2. R0.5
G71 P10 Q20 U0.4 W0.1 F0.25
N10 G0 X13.
G1 X20. Z-1.5 F0.1
Z-22.
X30. Z-40.
Z-50.
G2 X36. Z-53. R3.
G1 X44.
Z-64.
N20 X48.
G0 X100. Z50.
(T3 FINISH, DNMG 110404)
T0303
G50 S3500
G96 S260 M3
G0 X48. Z2.
G70 P10 Q20
G0 X100. Z50.
(T5 GROOVE AND PART OFF, 3 WIDE)
T0505
G97 S900 M3
G0 X48. Z2.
G0 X34. Z-22.
G1 X16. F0.06
G0 X34.
Z-63.
G1 X1.6 F0.05
G0 X48.
G28 U0 W0 M9
M5
M30
%
