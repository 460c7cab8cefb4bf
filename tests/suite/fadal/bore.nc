(machine: fadal-4020)
(A bore by helix, then two finishing turns.)
M6 T1
G90 G0 S5000 M3 E1 X2. Y-2.
H1 D1 Z.05 M8
X2.5 Z0 G1 F25. (= line to X2.5 Y-2 Z0)
X3. G41 (= line to X3)
G91 I-1. G3 Z-.3 L3 (= helix ccw center X2 Y-2 radius 1 sweep 360 to X3 Y-2 Z-.3 | helix to Z-.6 | helix to Z-.9)
I-1. G3 Z-.13 (= helix ccw to Z-1.03)
I-1. G3 L2 (= arc ccw center X2 Y-2 sweep 360 to X3 Y-2 Z-1.03 x2)
G90 X2. G40 G0 (= rapid to X2 Y-2)
M5 M9
G90 G0 H0 Z0
M2
