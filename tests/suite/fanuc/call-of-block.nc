(machine: fanuc-30i)
(M98 with Q and no P calls this program from block Q up to M99; with P it begins at block Q of that program.)
O1
G21 G17 G90 G94 S1000 M3
G0 X0. Y0.
M98 Q101
G0 X1. (= rapid to X1 Y5)
M98 Q101 L2
M98 P2000 Q50
M98 Q999 (= ! CH202)
M30
N101 G91 G0 Y5. (= rapid to X0 Y5 | rapid to X1 Y10 | rapid to X1 Y15)
G90
M99
O2000
G0 X20.
N50 G0 X30. (= rapid to X30 Y15)
M99
