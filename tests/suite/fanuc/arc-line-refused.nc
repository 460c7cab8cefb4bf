(machine: fanuc-30i)
(set: settings."No. 3403#5"=1)
G21 G17 G90 G94 S1000 M3
G0 X0. Y0.
G1 Z-1. F100.
G3 I-.5 (= arc ccw)
X-2.5 (= line to X-2.5 | ! CH405 "PS0022")
G2 X5. (= line to X5 | ! CH405 "PS0022")
M30
