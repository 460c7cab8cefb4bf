(machine: haas-vf2)
(expect: CH111)
(Remarks without their parentheses: one problem for each, however many lines it has, and the words)
(before it hold.)
G20 G17 G90 S1000 M3
G0 X0 Y0 Z0
G1 X1. F10. This is the move to the corner (= line to X1 feed 10 | ! CH111 "looks like a comment without parentheses")
Y1. (= line to Y1)
ROUGH THE POCKET AND LEAVE
STOCK ON THE WALLS
.015 FOR THE FINISH
X0 (= line to X0)
M30
