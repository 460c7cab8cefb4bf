(G254 with B in the work offset.)
(machine: umc-b5)
G21 G17 G90 G94
G53 G0 Z0.
T2 M6
S6000 M3
G54
G0 B30. C0.
G254 (= !)
M30
