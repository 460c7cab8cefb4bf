(An arc in a frame that stays, while a table axis turns that is not normal to the plane.)
(machine: ac-wkp)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G43.4 H2 X0. Y0. Z100.
G1 X20. F1000.
G3 X0. Y20. I-20. J0. A10. (= ! "PS5421")
M30
