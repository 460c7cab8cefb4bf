(Vectors of P3 that are 6 degrees off square.)
(machine: ac)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G68.2 P3 Q1 X0. Y0. Z0. I1. J0. K0. (= !)
G68.2 P3 Q2 I0.10453 J0. K0.99452 (= !)
G53.1
M30
