(The third point without the second.)
(machine: ac)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G68.2 P2 Q1 X0. Y0. Z0. (= !)
G68.2 P2 Q3 X0. Y10. Z0. (= !)
G53.1 (= !)
M30
