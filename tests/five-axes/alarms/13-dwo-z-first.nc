(A cut after G254 before X and Y are named.)
(machine: umc)
G21 G17 G90 G94
G53 G0 Z0.
T2 M6
S6000 M3
G54
G0 X0. Y0.
B30. C0.
G254
G43 Z50. H2
G1 Z20. F300. (= !)
M30
