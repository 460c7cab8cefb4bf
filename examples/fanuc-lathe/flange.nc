%
O2203 (FLANGE 120, FACED IN PASSES)
(machine: fanuc-lathe)
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.8 mm")
(set: tools.1.tip=3)
(set: tools.2.offset.X="-102 mm")
(set: tools.2.offset.Z="-52 mm")
(set: tools.2.nose_radius="0.8 mm")
(set: tools.2.tip=2)
G21 G18 G40 G80 G99
T0101 (OD AND FACE, CNMG 0.8)
G50 S1800
G96 S220 M03
G0 X124. Z3. M08
G72 W2. R0.5
G72 P10 Q20 U0.5 W0.2 F0.3
N10 G0 Z-22.
G1 X80. F0.2
Z-8.
X60. Z-3.
N20 Z2.
G70 P10 Q20
G0 X150. Z80.
T0202 (BORE)
G50 S2000
G96 S160 M03
G0 X34. Z2.
G71 U1.5 R0.5
G71 P30 Q40 U-0.4 W0.1 F0.2
N30 G0 X50.
G1 Z0 F0.12
X46. Z-2.
Z-18.
X40.
Z-30.
N40 X34.
G70 P30 Q40
G0 Z20. M09
G28 U0 W0
M30
%
