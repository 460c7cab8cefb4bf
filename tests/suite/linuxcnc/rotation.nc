(machine: linuxcnc-mill)
(units: mm)
(A work coordinate system turned by G10 L2 R. Places are those of the system before its turn.)
G21 G17 G90 G94 S500 M3
G0 X0 Y0 Z0
G10 L2 P1 X100 Y50 R30
G0 X10 Y0 (= rapid to X8.660254 Y5)
(G53 goes by unturned machine axes: an axis that is not named keeps its machine coordinate.)
G53 G0 X0 Y0 (= rapid to X-100 Y-50)
G0 X0 Y0 (= rapid to X0 Y0)
G53 G0 X110 (= rapid to X10 Y0)
G91 G0 X10 (= rapid to X18.660254 Y5)
G90
(G10 L20: so that the present place gets these coordinates, in the turned system.)
G0 X5 Y6 (= rapid to X1.330127 Y7.696152)
G10 L20 P1 X1 Y2
G0 X2 Y2 (= rapid to X.732051 Y2.732051)
G10 L20 P1 X0 R10 (= none | ! CH303)
(Arcs turn with the system, in all planes.)
G10 L2 P1 X0 Y0 R90
G0 X0 Y0 Z0 (= rapid to X0 Y0 Z0)
G2 X10 Y0 I5 J0 F100 (= arc cw to X0 Y10 center X0 Y5 radius 5.00 sweep 180.00)
G18
G3 X0 Z0 I-5 K0 (= spline)
G17
(The turn belongs to the system.)
G55
G0 X3 Y4 (= rapid to X3 Y4)
G54
G0 X3 Y4 (= rapid to X-4 Y3)
M2
