(G68.4 without an active plane.)
(machine: ac)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G68.4 X0. Y0. Z0. I0. J15. K0. (= !)
M30
