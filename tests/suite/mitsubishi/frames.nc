(machine: mitsubishi-m700)
(set: work_offsets.G54.X="-500 mm")
(set: work_offsets.G54.Y="-250 mm")
(set: work_offsets.G55.X="-400 mm")
(set: work_offsets.G55.Y="-250 mm")
(The angle in G91 adds; an axis without a centre is not scaled.)
G21 G17 G90 G94 S500 M3
G0 X0 Y0 Z0 (= rapid to X0 Y0 Z0)
G90 G68 X0 Y0 R30.
G91 G68 X0 Y0 R15.
G90 G0 X10. Y0 (= rapid to X7.071068 Y7.071068)
G69
G0 X0 Y0
G51 X0 P2.
G0 X10. Y5. (= rapid to X20 Y5)
G2 X20. Y-5. R10. F100. (= ! CH431 "P70")
G50
(Another work offset leaves the centre of a rotation where it is on the machine.)
G90 G54 G68 X0 Y0 R90.
G55
G0 X0 Y0 (= rapid to X-100 Y100)
G69
G54
G68.2 X0 Y0 Z0 I0 J30. K0 (= none)
G69
G68.2 P2 Q1 X0 Y0 Z0 (= none | ! CH449 "without Q2" | ! CH312 "the plane is not known")
M30
