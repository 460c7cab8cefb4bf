(An arc with I J scaled unequally: the radii are 100 and 200.)
(machine: ac)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G0 X0. Y100.
G51 X0. Y0. Z0. I2. J1. K1.
G2 X100. Y0. I0. J-100. F500. (= ! "PS0020")
M30
