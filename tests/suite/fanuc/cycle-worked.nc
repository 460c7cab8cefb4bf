(machine: fanuc-30i)
(set: settings."No. 5213"="0.5 mm")
(G99 to G98 at R; peck tapping by the lift; events of the bores.)
G21 G17 G90 G94 F100.
S1000 M3
G0 X1. Y-.5 Z2.
G81 G99 X1. Z-.5 R.1 (= rapid to Z.1 | line to Z-.5 | rapid to Z.1)
G98 X2. (= rapid to X2 Y-.5 Z.1 | line to Z-.5 | rapid to Z2)
X4. (= rapid to X4 Y-.5 Z2 | rapid to Z.1 | line to Z-.5 | rapid to Z2)
G80
G0 X0. Y0. Z20.
G84 X10. Z-5. R2. Q3. F1000. (= rapid to X10 Z20 | rapid to Z2 | line to Z-1 | spindle off | spindle ccw | line to Z-.5 | spindle off | spindle cw | line to Z-4 | spindle off | spindle ccw | line to Z-3.5 | spindle off | spindle cw | line to Z-5 | spindle off | spindle ccw | line to Z2 | spindle off | spindle cw | rapid to Z20)
G80
M30
