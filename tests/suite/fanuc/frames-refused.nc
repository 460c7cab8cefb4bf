(machine: fanuc-30i)
(expect: CH601)
(set: tools.1.diameter="10 mm")
(set: tools.1.length="100 mm")
(What a Fanuc refuses of scaling and rotation, and what its manuals ask not to do.)
G21 G17 G90 G94 S500 M3
G0 X0 Y0 Z10.
(PS0142: a factor of 0, or of 10000 and more.)
G51 X0 Y0 P0 (= none | ! CH430 "scale factor of 0" "PS0142")
G51 X0 Y0 P10000. (= none | ! CH430 "10000" "PS0142")
G51 X0 Y0 I2. J0 K1. (= none | ! CH430 "PS0142")
(PS0143: scaled numbers of more than eight digits, 99999.999 mm.)
G51 X0 Y0 P9999.
G0 X10. Y0 (= rapid to X99990)
X10.002 (= rapid to X100009.998 | ! CH440 "X goes to 100009.998 mm" "holds 99999.999 mm" "PS0143")
X0 Y0 (= rapid to X0 Y0)
G2 X0 Y0 I10.002 F100. (= arc cw to X0 Y0 radius 100009.998 | ! CH440 "the radius is 100009.998 mm" "PS0143")
G50
(PS0144: an arc in another plane than that of the rotation.)
G0 X0 Y0
G68 X0 Y0 R30.
G18 (= none | ! CH432 "PS0144")
G3 X10. Z10. I5. K0 (= ! CH432 "an arc in ZX" "PS0144")
G17
G0 X0 Y0 Z10.
G69
(A rotation about an axis in space: the words of its block.)
G68 X0 Y0 Z0 J0 K0 R30. (= none | ! CH438 "without I" "PS5044" | ! CH312)
G69
G68 X0 Y0 Z0 I0 J0 K1. (= none | ! CH438 "without R" "PS5044" | ! CH312)
G69
G68 X0 Y0 Z0 I0 J0 K0 R30. (= none | ! CH438 "all 0" "PS5044" | ! CH312)
G69
G68 X0 U0 I1. J0 K0 R30. (= none | ! CH438 "X and U" "PS0047" | ! CH304 | ! CH312)
G69
(Two of them, one in another, and no third.)
G68 X0 Y0 Z0 I1. J0 K0 R30. (= none)
G68 X0 Y0 Z0 I0 J1. K0 R30. (= none)
G68 X0 Y0 Z0 I0 J0 K1. R30. (= none | ! CH438 "rotation 3 in space" "PS5043")
G69
(Compensation is off before it; a length offset is around it or inside it.)
G41 D1 G1 X20. Y0
G68 X0 Y0 Z0 I1. J0 K0 R30. (= none | ! CH438 "cutter compensation is on" "PS0049")
G69
G40 G1 X40.
G68 X0 Y0 Z0 I1. J0 K0 R30. (= none)
G43 H1
G69 (= none | ! CH438 "does not end inside it" "PS0049")
G68 X0 Y0 Z0 I1. J0 K0 R30. (= none)
G43 H1 (= none | ! CH438 "another length offset" "PS0049")
G49
G69 (= none | ! CH438 "ends inside it" "PS0049")
G43 H1
G68 X0 Y0 Z0 I1. J0 K0 R30. (= none)
G69
G49
(An offset in space is not followed, and scaling may not begin in it.)
G41 D1 I1. J0 K1. (= none | ! CH312 "offset in space")
G51 X0 Y0 P2. (= none | ! CH438 "PS0141" | ! CH434)
G40
G50
(Two frames in one block.)
G51 P2. G68 X0 Y0 R30. (= none | ! CH302 "only G68 is carried out")
G69
(Reference points and work offsets while a frame is active.)
G0 X0 Y0
G68 X0 Y0 R30.
G55 (= none | ! CH433 "G55 while rotation is active")
G54 G69
G51 X0 Y0 P2.
G54.1 P1 (= none | ! CH433 "G54.1 while scaling is active")
G50
G54
(A cycle along an axis that is mirrored.)
G0 X0 Y0 Z10.
G51.1 Z0
G81 X10. Y0 Z-15. R-12. F100. (= rapid to X10 | rapid to Z12 | line to Z15 | rapid to Z10 | ! CH441 "along Z, which is mirrored")
G80
G50.1 Z0
M30
