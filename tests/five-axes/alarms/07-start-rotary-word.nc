(A rotary word in the start block of G43.5.)
(machine: mit)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G43.5 H2 X0. Y0. Z100. A10. (= ! "P33")
M30
