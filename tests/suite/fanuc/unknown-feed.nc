%
O1 (A FEED OF A VARIABLE THAT THE SHOP KEEPS)
(machine: fanuc-30i)
G21 G17 G90 G94 S1000 M3
G0 X0 Y0 Z0
G1 X1. F#652 (= line to X1 | ! CH726 "#652 and #653" "keep their values over power-off" "--set" | ! CH730 "#652")
X2. F[#653*2] (= line to X2)
G2 X4. R1. (= arc to X4)
G1 X5. F100. (= line to X5 feed 100)
M30
%
