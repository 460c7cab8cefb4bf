(G68.3 while a plane is active.)
(machine: ac)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G68.2 J30.
G53.1
G68.3 (= ! "PS5456")
M30
