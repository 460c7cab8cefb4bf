(machine: linuxcnc-mill)
(units: mm)
(Calculator numbers, comments of both kinds, blanks in numbers, presets, inverse time.)
G21 G90 G17 S1000 M3 ; a comment; G1 X99
G0 X0 Y0 Z0
G1 X10 F100 (= line to X10 feed 100)
X1 2.5 (= line to X12.5)
G4 P0.5 (= none)
G92 X0 (= none)
X1 (= line from X0 to X1)
G92.1
X14 (= line from X13.5 to X14)
G93 X15 F2 (= line to X15 feed 2)
G94 X16 F100 (= line to X16 feed 100)
G91 X1 (= line to X17)
G90 G53 X20 (= line to X20)
M2
