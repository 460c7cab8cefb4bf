(machine: fanuc-30i)
(A control that takes eight digits refuses more, whether a point is written or not.)
G21 G17 G90 G94 S1000 M3
G0 X0. Y0. Z0.
G1 X3.14159265358979323846 F100. (= line to X3.141 | ! CH311 "21 digits" "PS0003" | ! CH310)
G92 Y123456789 (= none | ! CH311 "9 digits")
G92 Y0
N12345678 X4. (= line to X4)
N99999999 X5. (= line to X5)
M30
