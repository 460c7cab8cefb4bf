%
O2211 (TWO FLATS MILLED IN Y)
(machine: fanuc-lathe-y)
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.8 mm")
(set: tools.1.tip=3)
(set: tools.10.offset.X="-110 mm")
(set: tools.10.offset.Z="-60 mm")
G21 G18 G40 G80 G99
T0101
G50 S2000
G96 S180 M03
G0 X44. Z1. M08
G1 X40. F0.2
Z-30.
X44.
G0 X120. Z50. M05
G28 H0
T1010 (LIVE END MILL 16 ALONG X)
G98
G97 S2000 M03
G0 X60. Y-32. Z-10. C0
G1 X34. F400.
Y32. F200.
G0 X60.
C180. Y-32.
G1 X34. F400.
Y32. F200.
G0 X60.
Y0
G0 X120. Z50. M09
G99
G28 U0 W0
G28 V0 H0
M30
%
