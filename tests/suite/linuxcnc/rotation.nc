(machine: linuxcnc-mill)
(units: mm)
(expect: CH531)
(set: tools.1.diameter="2 mm")
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
G10 L20 P1 X0 R10 (= none | ! CH303 "R not allowed in G10 L20")
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
(G92 lives inside of the turn; its numbers are those of turned coordinates. G53 is not moved by it.)
G10 L2 P1 X100 Y50 R30
G0 X10 Y0 (= rapid to X8.660254 Y5)
G53 G0 X0 Y0
(PRINT, #5420 #5421) ;(= > " -111.602540 6.698730")
G0 X10 Y20
G92 X0 Y0
(PRINT, #5210 #5211 #5212 #5420 #5421) ;(= > " 1.000000 0.393701 0.787402 0.000000 0.000000")
G53 G0 X100 Y50
(PRINT, #5420 #5421) ;(= > " -10.000000 -20.000000")
G92.1
(G10 L20 counts in the turned system.)
G0 X10 Y20
G10 L20 P1 X0 Y0
(PRINT, #5221 #5222 #5230) ;(= > " 3.884262 2.847264 30.000000")
(The tool offset lies outside of the turn.)
G10 L2 P1 X100 Y50
G43.1 X7
G53 G0 X100 Y50
(PRINT, #5420 #5421) ;(= > " -6.062178 3.500000")
G49
(G28 takes the axes that it names to the coordinates of the point in the turned system.)
G0 X1 Y2
G28.1
G0 X3 Y7
G28 Y5
(PRINT, #5420 #5421) ;(= > " 3.000000 2.000000")
G28 X5
(PRINT, #5420 #5421) ;(= > " 1.000000 2.000000")
(G10 L20 with one axis leaves the turned coordinate of the other.)
G10 L20 P1 X8
(PRINT, #5420 #5421) ;(= > " 8.000000 2.000000")
(of another system, by its own turn)
G10 L2 P2 X0 Y0 R90
G10 L20 P2 X1 Y2
G55
(PRINT, #5420 #5421 #5250) ;(= > " 1.000000 2.000000 90.000000")
(With compensation on it may not change under the tool.)
G54 G10 L2 P1 X0 Y0 R0
G0 X0 Y0
G41 D1 G1 X10 Y0
X20
G10 L2 P2 R5
X30
G10 L2 P1 R5 (= ! CH517 "Cannot change the active coordinate system with cutter radius compensation on")
G40 G1 X40
M2
