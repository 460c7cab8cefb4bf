(An arc while one of its two axes is scaled.)
(machine: mit)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G0 X0. Y0.
G51 X0. P2.
G2 X10. Y10. R10. F500. (= ! "P70")
M30
