(An arc under G143.)
(machine: haas-ab)
G21 G17 G90 G94
G53 G0 Z0.
T2 M6
S6000 M3
G54
G0 A0. B0. X0. Y0.
G143 H2 X0. Y0. Z50. A0. B0.
G1 Z20. F500.
G2 X10. Y0. I5. J0. (= !)
M30
