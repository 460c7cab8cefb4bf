(machine: haas-vf2)
(set: settings.units="mm")
G21 G17 G90 G94 G54 S1000 M3
G0 X0. Y0. Z5.
G81 Z-1. R500 F100. (= rapid to Z.5 | line to Z-1 | rapid to Z5)
G80
G1 X5. F100.
G2 X6. Y0. R018 (= ! CH305 "R18" | ! CH402)
M30
