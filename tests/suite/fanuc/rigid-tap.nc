(machine: fanuc-30i)
(M29 prepares rigid tapping and takes the speed in its block; it moves nothing. Without Q the tap goes down at once.)
G21 G17 G90 G94 F1000.
G0 X0. Y0. Z20.
S500 M3
M29 S1000 (= none)
G99 G84 X10. Z-4. R2. (= rapid to X10 Z20 | rapid to Z2 | line to Z-4 feed 1000 | spindle off | spindle ccw | line to Z2 | spindle off | spindle cw)
X20. I1. (= rapid to X20 | line to Z-4 | spindle off | spindle ccw | line to Z2 | spindle off | spindle cw | ! CH304 "`I`")
G80
M30
