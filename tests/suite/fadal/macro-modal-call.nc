(machine: fadal-4020)
(G66: a subroutine after each move, until G67. The block that begins it does not call.)
L100
Z-.1 (= line to X1 Y0 Z-.1 | line to X1 Y1 Z-.1 | line to X2 Y1 Z-.1)
#V1=V1+1
Z.1 (= line to Z.1 | line to Z.1 | line to Z.1)
M17
M30
S1000 M3
#V1=0
G90 G1 F20. X0 Y0 Z.1
G66 L101
X1. (= line to X1)
Y1. (= line to Y1)
M8
X2. (= line to X2)
G67
Y2. (= line to Y2)
#R1=V1
X+R1 (= line to X3)
M2
