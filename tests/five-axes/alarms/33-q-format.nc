(Q of G68.2 P1 that names an axis twice.)
(machine: ac)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G68.2 P1 Q112 I0. J30. K0. (= ! "PS5457")
M30
