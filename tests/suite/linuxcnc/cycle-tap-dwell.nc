(machine: linuxcnc-mill)
(units: mm)
(As rs274 runs it: a tap without P waits as long as the last cycle that had one.)
G21 G17 G90 G94 F100
S1000 M3
G0 X0 Y0 Z10
G99 G84 X1 Z-1 R1 (= rapid to X1 | rapid to Z1 | line to Z-1 | spindle off | spindle ccw | line to Z1 | spindle off | spindle cw)
G82 X2 Z-1 R1 P.3 (= rapid to X2 | line to Z-1 | dwell .3 | rapid to Z1)
G80
G84 X3 Z-1 R1 (= rapid to X3 | line to Z-1 | spindle off | spindle ccw | dwell .3 | line to Z1 | spindle off | spindle cw)
G80
M2
