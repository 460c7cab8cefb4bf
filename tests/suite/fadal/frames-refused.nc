(machine: fadal-4020)
(units: mm)
(expect: CH531)
(set: tools.1.diameter="10 mm")
(What a Fadal refuses of mirror and rotation.)
G21 G17 G90 S500 M3
G0 X0 Y0 Z0
(Compensation is off before the mirror changes.)
G51.1 X0
G0 X20. Y0 (= rapid to X-20 Y0)
G41 D1 G1 X30. Y10. F100.
X50.
G50.1 X0 (= none | ! CH434 "mirror image ends while cutter compensation is on")
G1 X70. Y10. (= ! CH511)
G40 X90. Y0
(One axis alone after a rotation.)
G0 X10. Y0
G68 X0 Y0 R+90.
X20. (= rapid to X10 Y20 | ! CH439 "names X alone")
G69
(G10 L13 to L15 read values of the control into R: what comes of it is not known.)
G10 L13 P1 R1+0 (= none | ! CH312 "G10 L13 reads a value of the control into R")
M30
