%
(machine: fanuc-30i)
O1
(A file as a Fanuc punches it: LF CR CR ends a line, and is one line end.)
G21 G17 G90 S1000 M3
G0 X0. Y0. Z0.
G1 X1. Q5. F100. (= line to X1 | ! CH304 "`Q`")
M98 P5
M30
O5
Y2. Q5. (= line to Y2 | ! CH304 "`Q`")
M99
%
