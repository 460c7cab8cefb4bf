(machine: fanuc-30i)
(set: settings."No. 5101#4-5"="11")
(RD2 and RD1 both 1: Q shifts to Y-; without Q there is none, and it is told.)
G21 G17 G90 G94 F100.
S1000 M3
G0 X0. Y0. Z20.
G98 G76 X10. Z-5. R2. (= rapid to X10 Z20 | rapid to Z2 | line to Z-5 | spindle oriented | rapid to Z20 | spindle cw | ! CH815)
X20. Q.5 (= rapid to X20 Z20 | rapid to Z2 | line to Z-5 | spindle oriented | rapid to X20 Y-.5 Z-5 | rapid to X20 Y-.5 Z20 | rapid to X20 Y0 Z20 | spindle cw)
G80
M30
