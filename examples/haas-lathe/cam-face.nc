%
O30009 (FLANGE: BOLT CIRCLE TAPPED M6, SIDE HOLES, A SQUARE 26 ON THE FACE, A GROOVE ON THE SHELL)
(machine: haas-lathe-y)
(set: settings.units="mm")
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.8 mm")
(set: tools.1.tip=3)
(set: tools.7.offset.X="-107 mm")
(set: tools.7.offset.Z="-57 mm")
(set: tools.8.offset.X="-108 mm")
(set: tools.8.offset.Z="-58 mm")
(set: tools.9.offset.X="-109 mm")
(set: tools.9.offset.Z="-59 mm")
(set: tools.10.offset.X="-110 mm")
(set: tools.10.offset.Z="-60 mm")
(set: tools.10.diameter="10 mm")
(set: tools.11.offset.X="-111 mm")
(set: tools.11.offset.Z="-61 mm")
G21 G18 G40 G80 G99
T101
G50 S2500
G96 S200 M03
G00 X66. Z0 M08
G01 X-1.6 F0.2
G00 X60. Z2.
G01 Z-30. F0.25
X66.
G53 G00 X0 M05
G53 G00 Z0
M154 (C AXIS)
G28 H0
T707 (LIVE DRILL 5 ALONG Z)
G98 M133 P2500
G00 X46. Z5. C0
G83 Z-14. R2. Q4. F200.
C90.
C180.
C270.
G80
G53 G00 X0 M135
G53 G00 Z0
T808 (LIVE TAP M6 ALONG Z)
G99 G97 S400
G00 X46. Z5. C0
G95 Z-12. R2. F1.
C90.
C180.
C270.
G80
G53 G00 X0
G53 G00 Z0
T909 (LIVE DRILL 4 ALONG X)
G98 M133 P3000
G00 X64. Z-24. C45.
G243 X44. R62. Q3. F120.
C225.
G80
G53 G00 X0 M135
G53 G00 Z0
T1010 (LIVE END MILL 10 ALONG Z)
M133 P2800
G00 X76. Z2. C0
Z-4.
G112
G17
G01 G42 X26. F250.
Y13.
X-26.
Y-13.
X26.
Y1.
G40 X76.
G113
G18
G00 Z50.
G53 G00 X0 M135
T1111 (LIVE END MILL 4 ALONG X)
M133 P4000
G00 X64. Z-26. C0
G01 X58. F80.
G19
G107 C0 Y0 R29.
G01 Y45.5531 F160.
G107
G18
G00 X64.
G53 G00 X0 M135
G53 G00 Z0 M09
M155
M30
%
