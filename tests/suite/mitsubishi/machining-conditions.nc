(machine: mitsubishi-m700)
(Machining conditions are chosen and cancelled; the path is as written.)
G21 G17 G90 G94 S1000 M3
G120.1 P1 Q1 (= none)
G0 X5. Y0. (= rapid to X5 Y0)
G120.1 P2 Q3
G1 X6. F100. (= line to X6)
G121 (= none)
M30
