%
O1 (GIVEN VALUES ARE KNOWN)
(machine: fanuc-30i)
(set: #652 = 250)
(set: macros.variables.500 = 1.5)
(set: #501 = 1)
(set: #5121 = .25)
G21 G17 G90 G94 S1000 M3
G0 X0 Y0 Z0
G1 X#500 F#652 (= line to X1.5 feed 250)
IF[#501EQ1]GOTO10
X99. (= none)
N10 X[#5121*4] (= line to X1)
M30
%
