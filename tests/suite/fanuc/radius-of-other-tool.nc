(machine: fanuc-0i)
(set: tools.1.diameter="10 mm")
(set: tools.2.diameter="16 mm")
(set: tools.21.diameter="10.4 mm")
(set: tools.3.diameter="16 mm")
G21 G17 G40 G49 G80 G90
T2 M6
G0 G54 X-30. Y-30. S1000 M3
G43 H2 Z5.
G1 Z-1. F100.
G41 D2 X0 Y-20.
Y40.
G40 X-30.
G0 Z5.
T1 M6
G0 X-30. Y-30. S1000 M3
G43 H1 Z5.
G1 Z-1.
(The radius of tool 2 for tool 1.)
G41 D2 X0 Y-20. (= ! CH612 "tool 1 cuts with D2" "its radius is 5 mm, that of D2 8 mm")
Y40.
G40 X-30.
(A second offset of the shop's own.)
G41 D21 X0 Y-20.
Y40.
G40 X-30.
G0 Z5.
M30
