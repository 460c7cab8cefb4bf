(The table turns while G254 is on.)
(machine: umc)
G21 G17 G90 G94
G53 G0 Z0.
T2 M6
S6000 M3
G54
G0 B30. C0.
G254
G0 X0. Y0.
G43 Z80. H2
C90. (= !)
G255
M30
