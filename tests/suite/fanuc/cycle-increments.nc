(machine: fanuc-30i)
(Lengths of cycles in least increments; an R of an arc is no such length.)
G21 G17 G90 G94 S1000 M3
G0 X0. Y0. Z5.
G83 Z-3. R50 Q1500 F100. (= rapid to Z.05 | line to Z-1.45 | rapid to Z.05 | rapid to Z-.45 | line to Z-2.95 | rapid to Z.05 | rapid to Z-1.95 | line to Z-3 | rapid to Z5)
G80
G82 Z-1. R200 P500 (= rapid to Z.2 | line to Z-1 | dwell .5 | rapid to Z5)
G80
G81 Z-1. R2 (= rapid to Z.002 | line to Z-1 | rapid to Z5 | ! CH305 "R2")
G80
G1 Z0. F100.
G2 X1. Y0. R018 (= ! CH305 "R18" | ! CH402)
M30
