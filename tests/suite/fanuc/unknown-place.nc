%
O1 (PLACES)
(machine: fanuc-30i)
G21 G17 G90 G94 S1000 M3
G0 X0 Y0 Z0
G1 X1. F100. (= line to X1)
X#500 Y5. (= line to Y5 | ! CH726 "#100, #500 and #501" "#100 keeps its value until power-off" | ! CH727 "`X` is computed from #500")
G91 X1. (= line)
G90
#1=#500*0+#501
X#1 (= none)
X[#100] Y6. (= line to Y6)
X7. (= line to X7)
M30
%
