(machine: fanuc-30i)
(R is left out: every cycle feeds from the initial level, which is noted once.)
G21 G17 G90 G94
G0 X0. Y0. Z5. S1000 M3
M29 S1000
G84 Z-8.5 F500. (= line to Z-8.5 feed 500 | spindle off | spindle ccw | line to Z5 | spindle off | spindle cw | ! CH800 "a tapping cycle without R: it feeds from the initial level")
X10. (= rapid to X10 Z5 | line to Z-8.5 | spindle off | spindle ccw | line to Z5 | spindle off | spindle cw)
G80
G81 X20. Z-3. F100. (= rapid to X20 Z5 | line to Z-3 | rapid to Z5)
(G99 returns to R, which is the initial level.)
G99 X30. (= rapid to X30 Z5 | line to Z-3 | rapid to Z5)
G80
G83 Z-3. Q4. (= line to Z1 | rapid to Z5 | rapid to Z2 | line to Z-3 | rapid to Z5)
G80
G98 G85 X0. Z-3. (= rapid to X0 Z5 | line to Z-3 | line to Z5)
G80
(In increments Z counts from there.)
G91 G81 X5. Z-8. (= rapid to X5 Z5 | line to Z-3 | rapid to Z5)
G90 G80
(An R from before stays, and cycles with R are as ever.)
G81 X10. Z-3. R2. (= rapid to X10 Z5 | rapid to Z2 | line to Z-3 | rapid to Z5)
G82 X20. Z-4. P100 (= rapid to X20 Z5 | rapid to Z2 | line to Z-4 | dwell .1 | rapid to Z5)
G80
M30
