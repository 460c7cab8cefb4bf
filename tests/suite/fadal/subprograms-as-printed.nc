(machine: fadal-4020)
(The same in O programs. The contour is cut short: it ends at X-.58 Y1.5 with a lead-out)
(of 1.56 where the subroutine has 1.96 and goes on.)
O1 (HELIX, ONE TURN DOWN
G91 I-.5 G3 Z-.1 (= helix ccw sweep 360 x4 | ! CH406 | ! CH413)
M99
O2 (POCKET
G91 D1
M98 P1 L4
L9601 R0+10. R1+.015 R2+2.96 R3+2.96 (= none | ! CH822)
X1.5 G41 G1 (= line to X1.5)
Y.98
X-.52 Y.52 I-.52 G3 (= arc ccw sweep 90)
X-1.56 G40 (= line to X-.58 Y1.5)
G90 Z.1 G0
M99 (= ! CH204)
