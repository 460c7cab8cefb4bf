(machine: fadal-4020)
(A helix into a pocket, a fixed routine, a last turn to the floor.)
M6 T1
G90 G0 S8000 M3 E1 X2. Y-1.5
H1 D1 Z.05 M8
X2.3 Z0 G1 F30. (= line to X2.3 Y-1.5 Z0)
G91
I-.3 G3 Z-.05 (= helix ccw center X2 Y-1.5 radius .3 sweep 360 to X2.3 Y-1.5 Z-.05 length 1.88562)
I-.3 G3 Z-.05 (= helix ccw to Z-.1)
I-.3 G3 Z-.04 (= helix ccw to Z-.14)
X-.3 F40. (= line to X2 Y-1.5 Z-.14)
L9601 R0+40. R1+.01 R2+2.98 R3+1.98 (= none | ! CH306 "L9601")
X.3 (= line to X2.3)
I-.3 G3 Z-.010 (= helix ccw sweep 360 to X2.3 Z-.15)
X-.3 F50. (= line to X2 Z-.15)
L9601 R0+50. R1+.01 R2+3. R3+2. (= none | ! CH306)
M5 M9
G90 G0 H0 Z0
M2
