%
(machine: grblhal)
(Nine digits, zeros in front are free; full circles without an axis word, P turns; G59.3 and G43.1 X.)
G21 G90 G17
/G0 X5 (= rapid to X5)
G0 X0.123456789 (= rapid to X0.12345679)
G00 X0000000012 (= rapid to X12)
G2 I5 F300 (= arc cw center X17 radius 5.0 sweep 360.0 feed 300)
G3 X12 Y0 I5 P2 (= arc ccw radius 5.0 sweep 720.0)
G43.1 X2 Z1
G0 X0 Z0 (= rapid to X0 Z0)
G49
G59.3 G10 L2 P9 X1
G0 X0 (= rapid to X0)
G54
T1 M6
M61 Q2
M64 P1
M70
G91
M72
G0 X5 Y0 (= rapid to X5 Y0)
G5 X10 Y0 I2 J2 P-2 Q2 F200 (= spline)
X15 P-2 Q-2 (= spline)
G80 G92 X0
G92.1
M60
M2
%
