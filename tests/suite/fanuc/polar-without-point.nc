(machine: fanuc-30i)
(units: mm)
(Angles count in thousandths where they have no point, as lengths do.)
G21 G90 G17 G54
T1 M6
G0 X0 Y0 S900 M3
G43 H1 Z5.
G16
G0 X20. Y45.
Y180 (= ! CH305 "0.18°")
Y270.
G15
G68 X0 Y0 R30 (= ! CH305 "0.03°")
G69
M30
