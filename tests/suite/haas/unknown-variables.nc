%
O00001 (#100 IS #10100 AND KEPT)
(machine: haas-vf2)
G20 G17 G90 G94 S1000 M3
G0 X0 Y0 Z0
#500= 1.
G1 X#10500 F#100 (= line to X1 | ! CH726 "#100, #10100 and #10999" | ! CH730 "#100")
IF [ #10999 EQ 1. ] THEN X9. (= none | ! CH728 "#10999")
#1= #5401 (= ! CH719 "#5401")
X2. F#10100 (= line to X2)
M30
%
