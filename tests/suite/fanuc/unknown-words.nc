%
O1 (TOOL, SPEED AND OFFSETS)
(machine: fanuc-30i)
(set: tools.1.diameter = 10 mm)
(set: tools.1.length = 50 mm)
G21 G17 G90 G94
G0 X0 Y0
T#520 M6 (= none | ! CH726 "#520, #521, #522 and #523")
S#521 M3 (= spindle cw)
G43 H#522 Z5. (= rapid to Z5)
G41 D#523 G1 X10. F100. (= line to X10)
Y10. (= line to Y10)
G40 X0 (= line to X0)
DPRNT[#520[40]] (= > "?" | ! CH725)
M30
%
