(machine: mitsubishi-m700)
(set: settings.'scaling option'="absent")
(set: settings.'rotation option'="absent")
(A machine without the options of scaling and rotation.)
G21 G17 G90 G94 S500 M3
G0 X0 Y0 Z10.
G51 X0 Y0 P2. (= none | ! CH435 "no option of scaling" "P350")
X10. Y0 (= rapid to X10 Y0)
G50
G68 X0 Y0 R90. (= none | ! CH436 "no option of rotation" "P260")
X20. Y0 (= rapid to X20 Y0)
G69
M30
