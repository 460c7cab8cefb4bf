(Vectors of P3 that are 4 degrees off square: no alarm.)
(machine: ac)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G68.2 P3 Q1 X0. Y0. Z0. I1. J0. K0.
G68.2 P3 Q2 I0.06976 J0. K0.99756
G53.1
G69
M30
