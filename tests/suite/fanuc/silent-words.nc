(machine: fanuc-30i)
(set: work_offsets.G54.X="-500 mm")
(Words that a code does not take, each with its answer.)
G21 G17 G90 G94 S1000 M3
G0 X0. Y0. Z20.
G99 G83 X10. Z-4. R2. Q6. F100. (= rapid to X10 Z20 | rapid to Z2 | line to Z-4 | rapid to Z2)
G83 X11. Z-4. R2. Q6. P500 (= rapid to X11 | line to Z-4 | rapid to Z2 | ! CH304 "`P`")
G83 X12. Z-4. R2. Q6. I1. J1. (= rapid to X12 | line to Z-4 | rapid to Z2 | ! CH304 "`I`" | ! CH304 "`J`")
G81 X13. Z-4. R2. L2 (= rapid to X13 | line to Z-4 | rapid to Z2 | ! CH304 "`L`" "cycle repeats")
X14. L2 (= rapid to X14 | line to Z-4 | rapid to Z2 | ! CH304 "`L`")
G85 X15. Z-4. R2. P500 (= rapid to X15 | line to Z-4 | line to Z2 | ! CH304 "`P`")
G82 X16. Z-4. R2. P500 K1 (= rapid to X16 | line to Z-4 | dwell .5 | rapid to Z2)
G80
G62 (= ! CH306 "G62 slows down in inside corners")
G64
G91 G53 X-480. (= none | ! CH304 "ignores G53 in G91" "G90 G53")
G90 G53 X-480. (= rapid to X20)
M30
