(F is missing in a block of G93.)
(machine: umc)
G21 G17 G90 G94
G53 G0 Z0.
T2 M6
S6000 M3
G54
G0 X0. Y0.
G43 Z50. H2
G93 G1 X10. B5. F100.
X20. B10. (= !)
M30
