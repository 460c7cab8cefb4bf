(machine: mitsubishi-m700)
(R is left out: a cycle feeds from the initial level.)
G21 G17 G90 G94 S1000 M3
G0 X0. Y0. Z5.
G81 Z-8.5 F100. (= line to Z-8.5 | rapid to Z5 | ! CH800 "a drilling cycle without R")
G80
G84 X5. Z-3. F100. ,R0 (= rapid to X5 Z5 | line to Z-3 | spindle off | spindle ccw | line to Z5 | spindle off | spindle cw)
G80
M30
