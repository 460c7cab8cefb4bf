(machine: mitsubishi-m700)
(set: tools.1.diameter="10 mm")
(What an M700 refuses of scaling and rotation.)
G21 G17 G90 G94 S500 M3
G0 X0 Y0 Z10.
(P35: a factor above 99.999999.)
G51 X0 Y0 P100. (= none | ! CH430 "scale factor of 100" "P35")
G51 X0 Y0 P100000000 (= none | ! CH430 "scale factor of 100" "P35")
(P70: an arc with unequal factors.)
G51 X0 Y0 I2. J3. K1.
G2 X10. Y10. R10. F100. (= ! CH431 "P70")
G50
(An arc after one axis alone: that of a scaling changes too.)
G0 X10. Y10.
G68 X0 Y0 R90.
X20. (= rapid to X10 Y20 | ! CH439 "Y was 10 mm before it and is -10 mm now" "goes to X 10 mm, Y 20 mm")
G69
(A rotation about an axis in space: what may not be active, beside it or in it.)
G0 X0 Y0
G41 D1 G1 X20. Y0
G68 X0 Y0 Z0 I1. J0 K0 R30. (= none | ! CH438 "cutter compensation is on" "P922")
G69
G40 G1 X40.
G43.4 H1 (= none | ! CH448)
G68.1 X0 Y0 Z0 I1. J0 K0 R30. (= none | ! CH438 "G43.4 is active" "P922" | ! CH312)
G49
G69
G43.1 H1 (= none | ! CH312)
G68 X0 Y0 Z0 I1. J0 K0 R30. (= none | ! CH438 "G43.1 is active" "P931")
G49
G69
G55 G68 X0 Y0 Z0 I1. J0 K0 R30. (= none | ! CH438 "G55 in the block" "P923")
G52 X1. (= none | ! CH438 "G52 while a rotation in space is active" "P921")
G52 X0 (= none | ! CH438 "P921")
G54 (= none | ! CH438 "P921")
G51 X0 Y0 P2. (= none | ! CH438 "P921")
G50
G43.1 H1 (= none | ! CH438 "P927" | ! CH312)
G43.4 H1 (= none | ! CH438 "P941" | ! CH448)
G49
G69
G52 X0
M30
