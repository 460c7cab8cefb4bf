(A trunnion that goes from -30 to 120 does not reach 130.)
(machine: ac)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G68.2 J130.
G53.1 (= !)
M30
