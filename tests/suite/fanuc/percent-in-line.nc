(machine: fanuc-30i)
(A percent sign with words after it is no end of the tape.)
G21 G17 G90 G0 X1. % X2. (= rapid to X2 | ! CH105 | ! CH106)
M30
