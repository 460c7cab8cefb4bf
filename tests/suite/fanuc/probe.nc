%
O0001 (G31: THE PLACE OF THE SKIP HAS THE TOOL LENGTH IN IT)
(machine: fanuc-30i)
(set: probe.hit.Z = -10 mm)
(set: tools.1.length = "50 mm")
(units: mm)
G21 G90 G17 G94 G40 G49 G80
G43 H1 G0 X0 Y0 Z0
G31 Z-25. F100. (= line to Z-10 feed 100 | ! CH732)
#1=#5063
G0 Z0 (= rapid to Z0)
X#1 (= rapid to X40)
G31 (= none)
G31 Z-5. (= line to Z-5)
M30
%
