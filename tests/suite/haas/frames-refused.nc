(machine: haas-vf2)
(units: mm)
(expect: CH531)
(set: tools.1.diameter="10 mm")
(What a Haas refuses of scaling, rotation and mirror image.)
G21 G17 G90 G94 S500 M3
G0 X0 Y0 Z10.
(P from .001 to 999.999, R up to 360 degrees.)
G51 X0 Y0 P1000. (= none | ! CH430 "scale factor of 1000")
G51 X0 Y0 P.0005 (= none | ! CH430 "scale factor of 0.0005")
G68 X0 Y0 R400. (= none | ! CH430 "rotation by 400°" "360°")
(G100 and G101 are alone.)
G0 G101 X0 (= none | ! CH307 "G101 must be the only G code")
G100 X0
(G51 and G68 are in blocks of their own.)
G51 P2. G68 X0 Y0 R30. (= none | ! CH302 "only G68 is carried out")
(The plane stays, and compensation ends before the rotation does.)
G18 (= none | ! CH432)
G17
G41 D1 G1 X20. Y10. F100.
X40.
G69 (= none | ! CH434 "rotation ends while cutter compensation is on")
X60. Y10.
G40 X80. Y0
(One axis alone, and another work offset.)
G0 X10. Y0
G68 X0 Y0 R90.
X20. (= rapid to X10 Y20 | ! CH439 "names X alone")
G55 (= none | ! CH433)
G69
(No rotation about an axis in space: I, J and K have no use.)
G54
G0 X0 Y0
G68 X0 Y0 I1. J0 K0 R90. (= none | ! CH304 | ! CH304 | ! CH304)
G0 X10. Y0 (= rapid to X0 Y10)
G69
M30
