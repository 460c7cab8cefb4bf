(machine: mitsubishi-m700)
(set: settings."#8012"="1 mm")
(set: settings."#8013"="1 mm")
(G73 waits at each peck, G83 not; G86 waits before the spindle stops; G75 is not drilled.)
G21 G17 G90 G94 F100.
S1000 M3
G0 X0. Y0. Z20.
G99 G73 X10. Z-5. R2. Q3. P100 (= rapid to X10 Z20 | rapid to Z2 | line to Z-1 | dwell .1 | rapid to Z0 | line to Z-4 | dwell .1 | rapid to Z-3 | line to Z-5 | dwell .1 | rapid to Z2)
G83 X20. (= rapid to X20 Z2 | line to Z-1 | rapid to Z2 | rapid to Z0 | line to Z-4 | rapid to Z2 | rapid to Z-3 | line to Z-5 | rapid to Z2)
G86 X30. (= rapid to X30 Z2 | line to Z-5 | dwell .1 | spindle off | rapid to Z2 | spindle cw)
G80
G75 X40. Z-5. R2. (= none | ! CH312)
M30
