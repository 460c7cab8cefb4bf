(A nutating axis of 45 degrees reaches level, not below it.)
(machine: nu)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G68.2 P1 J100.
G53.1 (= !)
M30
