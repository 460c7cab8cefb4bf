%
(machine: fanuc-30i)
(The mark of the tape's end on the line of M30.)
O1
G21 G17 G90 G0 X1. (= rapid to X1)
M30 % 
