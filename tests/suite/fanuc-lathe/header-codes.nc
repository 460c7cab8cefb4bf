(machine: fanuc-lathe)
(set: tools.13.offset.X="-100 mm")
(set: tools.13.offset.Z="-50 mm")
(set: settings."P of live tools"=12)
(Codes of a safety line: tapping mode, tool length off, and G95 of system B, which is said once.)
G21 G18 G40 G49 G63 G80 G99 (= none)
G64
G95 (= none | ! CH301 "is a code of system B")
G95 (= none)
(Five digits: station 13, offset 013.)
T13013
G97 S800 M3
G0 X50. Z2.
G1 Z-10. F.2 (= line to X50 Z-10)
G63
G1 Z-11. (= line to Z-11)
M30%
G0 X0. Z0. (= none)
