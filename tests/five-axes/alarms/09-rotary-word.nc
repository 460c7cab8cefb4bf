(A rotary word while the direction is given by I J K.)
(machine: ac)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G43.5 H2 X0. Y0. Z100.
G1 X10. I0. J-0.2 K0.98 F500.
X20. C10. (= !)
M30
