(machine: grblhal)
(set: axes.A.max_velocity = 3600 deg/min)
(set: axes.A.max_acceleration = 100 deg/s^2)
(units: mm)
(A machine file with an axis A is one of a build that has it.)
G21 G17 G90 G94
S1000 M3 F100
G0 X0 Y0 Z5 A0 (= rapid to A0)
G1 Z0 A90 (= line to Z0 A90)
A180 (= line to A180)
G91 A-45 (= line to A135)
G90 G2 X2 I1 A0 (= arc cw to X2 A0)
B5 (= ! CH313 "does not have this word")
M2
