(machine: fadal-4020)
(A slot with round ends: ramped roughing, then the wall twice round and out.)
M6 T6
G90 G0 S10000 M3 E1 X2. Y-1.5
H6 D6 Z.1 M8
Z.01 G1 F10.
G8
G91
X-1. Z-.135 F30. (= line to X1 Y-1.5 Z-.125 feed 30)
X1. (= line to X2 Y-1.5)
X-1. Z-.145 (= line to X1 Z-.27)
X1. (= line to X2)
X.19 G41 F50. (= line to X2.19 Y-1.5)
X-.19 Y.19 I-.19 G3 (= arc ccw center X2 Y-1.5 radius .19 sweep 90 to X2 Y-1.31)
X-1. (= line to X1 Y-1.31)
Y-.38 J-.19 G3 (= arc ccw center X1 Y-1.5 radius .19 sweep 180 to X1 Y-1.69)
X1. (= line to X2 Y-1.69)
Y.38 J.19 G3 (= arc ccw center X2 Y-1.5 sweep 180 to X2 Y-1.31)
X-1.
Y-.38 J-.19 G3 (= arc ccw radius .19 sweep 180 to X1 Y-1.69)
X1. (= line to X2 Y-1.69)
X.19 Y.19 J.19 G3 (= arc ccw center X2 Y-1.5 sweep 90 to X2.19 Y-1.5)
X-.19 G40 (= line to X2 Y-1.5)
G90
Z.1 G0
G0 G90 H0 Z0
M2
