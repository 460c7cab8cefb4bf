(machine: grblhal)
(set: settings.expressions="on")
G21 G90 G94 S1000 M3
G0 X0 Y0 Z0
G1 X1 F#100 (= line to X1 | ! CH726 "#100 and #101" | ! CH730)
X2 (= line to X2)
G2 X4 Y0 R#101 (= none | ! CH727 "#101")
G1 X1 Y0 F100 (= line to X1 Y0)
M30
