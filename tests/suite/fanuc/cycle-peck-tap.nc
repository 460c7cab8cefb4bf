(machine: fanuc-30i)
(set: settings."No. 5200#5"=1)
(Peck tapping that comes all the way out each time.)
G21 G17 G90 G94 F1000.
S1000 M3
G0 X0. Y0. Z20.
G99 G84 X10. Z-4. R2. Q3. P500 (= rapid to X10 Z20 | rapid to Z2 | line to Z-1 feed 1000 | spindle off | spindle ccw | line to Z2 | spindle off | spindle cw | line to Z-4 | spindle off | dwell .5 | spindle ccw | line to Z2 | spindle off | spindle cw)
G80
M30
