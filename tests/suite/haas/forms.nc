(machine: haas-vf2)
(The general forms: a full circle by I and J, a thread by one block, planes and their words.)
G20 G90 S1000 M03
G00 X0 Y0 Z0
G01 Z-.1 F20.
G02 I3.0 J4.0 (= arc cw center X3 Y4 radius 5 sweep 360 to X0 Y0 length 31.41593)
G02 I-1.0 Z-.15 F5. (= helix cw center X-1 Y0 radius 1 sweep 360 to Z-.15)
G18
G03 X1. Z.85 I0 K1. (= arc ccw plane zx center X0 Z.85 radius 1 sweep 270 to X1 Z.85)
G02 X0 Z-.15 J1. I-1. (= arc cw sweep 270 | ! CH404 "J does not belong")
G19
G02 Y1. Z.85 J0 K1. (= arc cw plane yz center Y0 Z.85 sweep 270 to Y1 Z.85)
G17
G02 X1. Y1. R.3 (= line to X1 Y1 Z.85 | ! CH402 "1 in apart" "302")
G02 X1. Y1. R.5 (= none | ! CH403 "refuses")
G02 X2. Y1. (= line to X2 Y1 | ! CH405)
G02 X3. Y1. I0. J0. (= line to X3 Y1 | ! CH412)
G02 X4. Y1. I.5 R.5 (= arc cw sweep 180 to X4 Y1 | ! CH409 "R is followed")
G41 G02 X5. Y1. R.5 D01 (= arc cw | ! CH501 "340 or 341")
G01 G40 X6. (= line to X6)
M30
