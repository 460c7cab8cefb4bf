%
O1
(machine: mitsubishi-m700)
G21 G17 G90 G94 S1000 M3
G0 X0 Y0 Z0
#450=2.
G1 X#450 F#700 (= line to X2 | ! CH726 "#100 and #700" "#700 keeps its value over power-off" | ! CH730)
X#100 (= none | ! CH727 "#100")
X3. (= line to X3)
M30
%
