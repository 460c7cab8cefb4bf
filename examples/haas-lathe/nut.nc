%
O30004 (NUT M36 X 2, THREAD INSIDE)
(machine: haas-lathe)
(set: settings.units="mm")
(set: tools.2.offset.X="-102 mm")
(set: tools.2.offset.Z="-52 mm")
(set: tools.2.nose_radius="0.4 mm")
(set: tools.2.tip=2)
(set: tools.6.offset.X="-106 mm")
(set: tools.6.offset.Z="-56 mm")
G21 G18 G40 G80 G99
T202
G50 S1800
G97 S800 M03
G00 X30. Z2. M08
G90 X32. Z-22. F0.2
X33.4
X33.8
G53 G00 X0 Z0
T606
G97 S500 M03
G00 X31. Z6.
M24
G76 X36. Z-24. K1.1 D0.3 F2.
M23
G53 G00 X0 M09
G53 G00 Z0
M30
%
