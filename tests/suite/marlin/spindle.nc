;(machine: snapmaker-2-a350)
; P of M3 is a power in percent: of 12000 a minute.
M3 P100 ; (= spindle cw)
G4 S2 ; (= dwell 2)
G21
G90
G0 X4.000 Y2.500 Z10.000 F1500 ; (= rapid to X4 Y2.5 Z10 feed 1500)
G1 X4.000 Y2.500 Z9.000 F200 ; (= line to Z9 feed 200)
M3 P150 ; (= ! CH303 "150 percent")
M5 ; (= spindle off)
M4 S6000 ; (= spindle ccw)
M5 ; (= spindle off)
G1 X330 ; the software endstop holds it at X320 (= line to X330 | ! CH601)
X5 ; this build does not go on without a code (= ! CH301 "begins with no command")
