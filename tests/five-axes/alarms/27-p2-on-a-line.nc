(Three points on a line.)
(machine: ac)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G68.2 P2 Q1 X0. Y0. Z0. (= !)
G68.2 P2 Q2 X10. Y0. Z2.
G68.2 P2 Q3 X20. Y0. Z4. (= !)
G53.1
M30
