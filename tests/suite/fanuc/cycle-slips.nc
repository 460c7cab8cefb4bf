(machine: fanuc-30i)
(A peck without its decimal point: too many pecks are told, and the hole is finished.)
G21 G17 G90 G94 F100.
S1000 M3
G0 X0. Y0. Z20.
G83 Z-200. R2. Q2 (= ! CH811 "202 mm" | ! CH305 "Q2.")
G80
M30
