%
O30001 (SHAFT, BAR 50)
(machine: haas-lathe)
(set: settings.units="mm")
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.8 mm")
(set: tools.1.tip=3)
(set: tools.3.offset.X="-103 mm")
(set: tools.3.offset.Z="-53 mm")
(set: tools.3.nose_radius="0.4 mm")
(set: tools.3.tip=3)
(set: tools.5.offset.X="-105 mm")
(set: tools.5.offset.Z="-55 mm")
(set: tools.7.offset.X="-107 mm")
(set: tools.7.offset.Z="-57 mm")
G21 G18 G40 G80 G99
G53 G00 X0
G53 G00 Z0
T101 (OD ROUGH)
G50 S2500
G97 S1000 M03
G00 X54. Z0.1 M08
G96 S200
G01 X-1.6 F0.2
G00 X52. Z2.
G71 P10 Q20 D2. U0.5 W0.1 F0.3
N10 G42 G00 X16.
G01 Z0 F0.12
X20. Z-2.
Z-30.
X28. R2.
Z-50.
X40. Z-58.
N20 G40 X52.
G53 G00 X0 Z0
T303 (FINISH)
G50 S3000
G96 S260 M03
G00 X52. Z2.
G70 P10 Q20
G53 G00 X0 Z0
T505 (GROOVE 3)
G97 S900 M03
G00 X30. Z-30.
G75 X17. F0.08
G53 G00 X0 Z0
T707 (THREAD M20 X 1.5)
G97 S900 M03
G00 X24. Z5.
G76 X18.16 Z-26. K0.92 D0.25 F1.5 A60
G53 G00 X0 M09
G53 G00 Z0
M30
%
