(machine: fadal-4020)
(Subroutines before the main program. L201 runs subroutine 2 once, L104 subroutine 1 four)
(times. The pocket's contour closes on its start.)
L100 (HELIX, ONE TURN DOWN
G91 I-.5 G3 Z-.1 (= helix ccw center X-.5 Y0 sweep 360 to X0 Y0 Z-.05 | helix to Z-.15 | helix to Z-.25 | helix to Z-.35)
M17
L200 (POCKET
G91 D1
L104
L9601 R0+10. R1+.015 R2+2.96 R3+2.96 (= none | ! CH822 "diameter for tool 1")
X1.5 G41 G1 (= line to X1.5 Y0 Z-.35)
Y.98 (= line to X1.5 Y.98)
X-.52 Y.52 I-.52 G3 (= arc ccw center X.98 Y.98 radius .52 sweep 90 to X.98 Y1.5)
X-1.96 (= line to X-.98)
X-.52 Y-.52 J-.52 G3 (= arc ccw sweep 90 to X-1.5 Y.98)
Y-1.96 (= line to Y-.98)
X.52 Y-.52 I.52 G3 (= arc ccw sweep 90 to X-.98 Y-1.5)
X1.96 (= line to X.98)
X.52 Y.52 J.52 G3 (= arc ccw sweep 90 to X1.5 Y-.98)
Y.98 (= line to X1.5 Y0)
X-1.5 G40 (= line to X0 Y0 Z-.35)
G90 Z.1 G0 (= rapid to Z.1)
M17
M30
********MAIN PROGRAM *********
M6 T1
G0 G90 S200 M3 E1 X0 Y0
H1 Z.1 M7 (= rapid to X0 Y0 Z.1)
G1 Z.05 F10. (= line to Z.05)
L201
G0 G90 H0 Z0
E0 X0 Y0
M2
