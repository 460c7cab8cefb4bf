(machine: fanuc-30i)
(X of a dwell is a time and no motion; units change block by block; feed per revolution and inverse)
(time.)
(total: dwells 3)
G21 G17 G90 S1000 M3
G0 X25.4 Y0. Z0.
G4 X1.5 (= none)
G4 P500 (= none)
G04 U2. (= none)
G20 G1 X2. F10. (= line to X50.8 feed 254)
G91 X1. (= line to X76.2)
G21 X1. (= line to X77.2)
G90 G95 X80. F.1 (= line to X80 feed .1)
G93 X90. F2. (= line to X90 feed 2)
X91. (= line to X91 | ! CH406 "inverse time")
G94 X92. F100. (= line to X92 feed 100)
M30
