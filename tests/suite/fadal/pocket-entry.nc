(machine: fadal-4020)
(set: tools.1.diameter="0.375 in")
(A helix into a pocket, a fixed routine, a last turn to the floor. The tool's radius is .1875)
(and its flat .1775, so the rings are at most .30303 apart: three of them, .8025/3 = .2675)
(apart in the rough pocket. The middle line is 2 x .5 long, the walls are X2 +-1.3025 and)
(Y-1.5 +-.8025 away.)
M6 T1
G90 G0 S8000 M3 E1 X2. Y-1.5
H1 D1 Z.05 M8
X2.3 Z0 G1 F30. (= line to X2.3 Y-1.5 Z0)
G91
I-.3 G3 Z-.05 (= helix ccw center X2 Y-1.5 radius .3 sweep 360 to X2.3 Y-1.5 Z-.05 length 1.88562)
I-.3 G3 Z-.05 (= helix ccw to Z-.1)
I-.3 G3 Z-.04 (= helix ccw to Z-.14)
X-.3 F40. (= line to X2 Y-1.5 Z-.14)
L9601 R0+40. R1+.01 R2+2.98 R3+1.98 (= line to X2.5 Y-1.5 Z-.14 feed 40 | line to X1.5 Y-1.5 | line to X1.2325 Y-1.5 | line to X1.2325 Y-1.7675)
(= line to X2.7675 Y-1.7675 | line to X2.7675 Y-1.2325 | line to X1.2325 Y-1.2325 | line to X1.2325 Y-1.5)
(= line to X.965 Y-1.5 | line to X.965 Y-2.035 | line to X3.035 Y-2.035 | line to X3.035 Y-.965 | line to X.965 Y-.965 | line to X.965 Y-1.5)
(= line to X.6975 Y-1.5 | line to X.6975 Y-2.3025 | line to X3.3025 Y-2.3025 | line to X3.3025 Y-.6975 | line to X.6975 Y-.6975 | line to X.6975 Y-1.5)
(= line to X2 Y-1.5 feed 40)
X.3 (= line to X2.3)
I-.3 G3 Z-.010 (= helix ccw sweep 360 to X2.3 Z-.15)
X-.3 F50. (= line to X2 Z-.15)
L9601 R0+50. R1+.01 R2+3. R3+2. (= line to X2.5 feed 50 | line to X1.5 | line x12 | line to X.6875 Y-1.5 | line to X.6875 Y-2.3125)
(= line to X3.3125 Y-2.3125 | line to X3.3125 Y-.6875 | line to X.6875 Y-.6875 | line to X.6875 Y-1.5 | line to X2 Y-1.5 Z-.15)
M5 M9
G90 G0 H0 Z0
M2
