(machine: linuxcnc-mill)
(Arcs in three planes; P counts all turns; absolute centres by G90.1; tolerances.)
G20 G90 G17 F10 S1000 M3
G0 X0 Y0 Z0
G2 X1 Y0 I.5 P2 Z-1 (= helix cw center X.5 Y0 radius .5 sweep 540 to X1 Y0 Z-1 length 4.81732)
G3 I.5 (= arc ccw center X1.5 Y0 radius .5 sweep 360 to X1 Y0)
G2 X2 R-.6 (= arc cw center X1.5 Y.33166 radius .6 sweep 247.115 to X2 Y0)
G90.1 G3 X1 Y0 I1.5 J0 (= arc ccw center X1.5 Y0 radius .5 sweep 180 to X1 Y0)
G91.1 G3 X2 Y0 I.5 J0 (= arc ccw center X1.5 Y0 radius .5 sweep 180 to X2 Y0)
G18 G3 X3 Z0 I1 K0 (= arc ccw plane zx center Z-1 X3 radius 1 sweep 90 to X3 Z0)
G19 G3 Y1 Z1 J1 K0 (= arc ccw plane yz center Y1 Z0 radius 1 sweep 270 to Y1 Z1)
G17 G2 X3 Y1 R1 (= none | ! CH403 "same as end point")
G2 X4 Y1 I.5 R.5 (= line to X4 Y1 | ! CH409 "Mixed")
G2 X5 Y1 J0 I.5004 (= arc cw radius .5004..0.4996 sweep 180 to X5 Y1)
G2 X6 Y1 I.502 (= arc cw | ! CH401 "0.004 in")
G2 X7 (= line to X7 | ! CH405)
M2
