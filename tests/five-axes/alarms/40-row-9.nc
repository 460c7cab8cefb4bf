(An arc with Settings 188 and 189 unequal.)
(machine: haas-scale)
G21 G17 G90 G94
G54
G0 X0. Y0.
G51
G2 X10. Y0. I5. J0. F500. (= !)
M30
