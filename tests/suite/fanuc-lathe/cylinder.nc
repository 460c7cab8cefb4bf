(machine: fanuc-lathe-c)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(C in degrees is a length on the cylinder, in Y: 1 degree is 0.87266 mm at radius 50.)
G21 G18 G40 G80 G98 G97 S1000 M3
T0101
G0 X104. Z0 C0
G7.1 C50.
G1 X100. F500. (= line to X100 Y0 Z0)
Z30. C60. (= line to Y52.3598775598 Z30 length 60.35 feed 500)
Z0 C0 (= line to Y0 Z0)
(In G18 arcs turn from Z to C; only R gives their centre.)
G3 Z20. C22.918312 R20. (= arc to Z20 Y20 plane yz radius 20.00 sweep 90.00)
G2 Z0 C45.836624 R20. (= arc to Z0 Y40 plane yz radius 20.00 sweep 90.00)
G3 Z20. C22.918312 K20. (= ! CH443 "only R gives its centre" "PS0176" | ! CH312)
G1 Z0 H-10. (= line to Y11.2733539)
G0 X120. (= rapid to X120 | ! CH442 "PS0176")
G1 X120.
G28 U0 (= none | ! CH442 "G28 in cylindrical interpolation" "PS0176")
G12.1 (= none | ! CH443 "PS0146")
(With the radius 0 it ends: C is where it came to, in degrees.)
G1 C90.
G7.1 C0 (= none)
G0 X130. (= rapid from X120 C90 to X130 C90)
(The other plane for arcs, as No. 1022 may have it: G19, C before Z.)
G19
G107 C20.
G1 C0 Z0
G3 Z10. C28.6478898 R10. (= arc ccw plane yz radius 10.00 sweep 90.00)
G107 C0
G17
G107 C20.
G1 C0 Z0
G3 Z10. C28.6478898 R10. (= ! CH443 "a plane without the rotary axis" | ! CH312)
G107 C0
(A radius, and an axis that turns.)
G7.1 C-5. (= none | ! CH443 "negative" "PS0175" | ! CH312)
G7.1 Z5. (= none | ! CH443 "without its rotary axis" "PS0175")
M30
