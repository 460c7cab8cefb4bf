%
(machine: fanuc-30i)
O1
(G10 L50 to G11: parameters of the control. Their N is a number of a parameter, P an axis, R a value.)
G21 G17 G90 S1000 M3
G0 X0. Y0. Z0.
G1 X1. F100. (= line to X1)
G10 L50 (= none | ! CH306 "G10 L50 writes parameters" "G11")
N1825 P1 R3000 (= none)
N1825 P2 R3000 (= none)
N3410 R10 (= none)
N3401 Q5 R1 (= none)
N100 R7 (= none)
G11 (= none)
X2. (= line to X2)
G10 L52 (= none | ! CH306)
N12320 P1 R1. (= none)
G1 X3. (= line to X3 | ! CH308 "no G11 ended")
X4. (= line to X4)
M98 Q100
M30
N100 G91 Y1. (= line to Y1)
G90 M99
%
