(machine: fanuc-30i)
(set: settings."No. 6200#2"=1)
(The shift of G76 and G87 by I and J.)
G21 G17 G90 G94 F100.
S1000 M3
G0 X0. Y0. Z20.
G99 G76 X10. Z-5. R2. I.3 J-.4 P100 (= rapid to X10 Z20 | rapid to Z2 | line to Z-5 | dwell .1 | spindle oriented | rapid to X10.3 Y-.4 Z-5 | rapid to Z2 | rapid to X10 Y0 Z2 | spindle cw)
G80
M30
