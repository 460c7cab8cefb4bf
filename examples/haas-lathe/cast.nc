%
O30008 (CASTING IN THREE PASSES, G73 IN ONE BLOCK)
(machine: haas-lathe)
(set: settings.units="mm")
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.8 mm")
(set: tools.1.tip=3)
(set: tools.3.offset.X="-103 mm")
(set: tools.3.offset.Z="-53 mm")
(set: tools.3.nose_radius="0.8 mm")
(set: tools.3.tip=3)
G21 G18 G40 G80 G99
T101
G50 S1500
G97 S600 M03
G00 X90. Z3. M08
G96 S160
G73 P10 Q20 I4. K2. D3 U0.5 W0.2 F0.25
N10 G00 X30. Z1.
G01 Z-15. F0.15
G02 X46. Z-23. R8.
G01 X60. Z-35.
N20 X80. Z-40.
G53 G00 X0 Z0
T303
G96 S220 M03
G00 X90. Z3.
G70 P10 Q20
G53 G00 X0 M09
G53 G00 Z0
M30
%
