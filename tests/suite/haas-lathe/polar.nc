(machine: haas-lathe)
(set: axes.C.max_velocity="600 deg/s")
(set: tools.1.offset.X="-4 in")
(set: tools.1.offset.Z="-2 in")
(set: tools.1.diameter=".5 in")
(G112 under G17: X and Y of the face, X as a diameter; rapids may be used.)
G20 G18 G40 G80 G98 G97 S1000 M3
T0101
G0 X2. Z.1 C0
G112
G17 (= none)
G0 X1.5 Y.5 (= rapid from X2 Y0 to X1.5 Y.5)
G1 Z-.1 F5.
X-1.5 (= line to X-1.5 Y.5 length 1.50)
G3 X-2. Y.25 R.25 (= arc ccw to X-2 Y.25 center X-1.5 Y.25 radius .25)
G1 Y0
C10. (= none | ! CH312 "C itself moves in polar interpolation")
G54 (= none | ! CH442 "G54 in polar interpolation")
G113
G0 Z1. (= rapid from X2 C180)
(G107: the named axis becomes the rotary one.)
G19
G107 C0 Y0 R1. (= none)
G1 Y0 F5. (= line to Y0)
Y1. Z-1. (= line to Y1 Z-1)
G3 Y1.5 Z-.5 R.5 (= arc ccw to Y1.5 Z-.5 plane yz radius .50)
G107 (= none)
G0 X3. (= rapid from C85.9436693 to X3 C85.9436693)
G107 C0 Y0 (= none | ! CH308 "radius" | ! CH312)
M30
