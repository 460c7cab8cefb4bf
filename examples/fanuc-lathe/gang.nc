%
O2208 (GANG LATHE: THE TOOL WORKS AT NEGATIVE X)
(machine: fanuc-lathe)
(set: tools.2.offset.X="-102 mm")
(set: tools.2.offset.Z="-52 mm")
(set: tools.3.offset.X="-103 mm")
(set: tools.3.offset.Z="-53 mm")
G21 G18 G40 G80 G99
T0202 (FRONT SIDE, X BELOW ZERO)
G50 S4000
G96 S120 M03
G0 X-18. Z2. M08
G71 U1. R0.3
G71 P10 Q20 U-0.3 W0.1 F0.15
N10 G0 X-8.
G1 Z-15. F0.08
X-12.
Z-30.
N20 X-18.
G70 P10 Q20
G0 X-60. Z30.
T0303 (OTHER SIDE)
G0 X14. Z-8.
G1 X10. F0.05
X14. F0.3
G0 X40. Z30. M09
G28 U0 W0
M30
%
