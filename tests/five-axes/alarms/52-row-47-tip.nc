(Tool centre point control in a conversion in space.)
(machine: mit)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G68.1 X0. Y0. Z0. I0. J0. K1. R10.
G43.4 H2 (= ! "P941")
M30
