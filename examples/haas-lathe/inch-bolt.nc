%
O30007 (BOLT 3/4-10 IN INCHES)
(machine: haas-lathe)
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.8 mm")
(set: tools.1.tip=3)
(set: tools.7.offset.X="-107 mm")
(set: tools.7.offset.Z="-57 mm")
G20 G18 G40 G80 G99
T101
G50 S2500
G97 S1000 M03
G00 X1.3 Z.1 M08
G96 S600
G71 P10 Q20 D.1 U.02 W.005 F.012
N10 G42 G00 X.65
G01 Z0 F.006
X.745 Z-.05
Z-2.
X1.1 K-.03
Z-2.3
N20 G40 X1.3
G70 P10 Q20
G53 G00 X0 Z0
T707
G97 S600 M03
G00 X.9 Z.3
G76 X.6273 Z-1.8 K.0613 D.0153 F.1 A60
G53 G00 X0 M09
G53 G00 Z0
M30
%
