%
(machine: mach3-mill)
(units: mm)
G21 G90 G17 F100 S1000 M3
G0 X0 Y0 Z0
#5=4
G1 X#5 (= line to X4)
X#6 (= none | ! CH726 "#6" | ! CH727 "#6")
X1 (= line to X1)
M30
%
