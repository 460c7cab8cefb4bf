%
O2212 (HEXAGON 30 MILLED ON THE FACE, AND A CAM GROOVE ON THE SHELL)
(machine: fanuc-lathe-c)
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.8 mm")
(set: tools.1.tip=3)
(set: tools.10.offset.X="-110 mm")
(set: tools.10.offset.Z="-60 mm")
(set: tools.10.diameter="12 mm")
(set: tools.11.offset.X="-110 mm")
(set: tools.11.offset.Z="-60 mm")
G21 G18 G40 G80 G99
T0101
G50 S2000
G96 S180 M03
G0 X44. Z1. M08
G1 X40. F0.2
Z-40.
X44.
G0 X120. Z50. M05
G28 H0
T1010 (LIVE END MILL 12 ALONG Z)
G98
G97 S2500 M03
G0 X70. Z2. C0
Z-8.
G12.1
G1 G42 X30. F300.
C8.66
X0 C17.32
X-30. C8.66
C-8.66
X0 C-17.32
X30. C-8.66
C1.
G40 X70.
G13.1
G0 Z50. M05
G28 H0
T1111 (LIVE END MILL 6 ALONG X)
G97 S3000 M03
G0 X44. Z-20. C0
G1 X36. F100.
G7.1 C18.
G1 C60. F200.
G3 Z-26. C79.099 R6.
G1 Z-28.
G2 Z-34. C98.197 R6.
G1 C261.803
G2 Z-28. C280.901 R6.
G1 Z-26.
G3 Z-20. C300. R6.
G1 C360.
G7.1 C0
G0 X120. Z50. M09
G99
G28 U0 W0
G28 H0
M30
%
