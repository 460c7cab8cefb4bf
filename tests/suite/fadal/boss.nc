(machine: fadal-4020)
(set: tools.3.diameter="0.5 in")
(A boss turned twice: absolute, then incremental; G2 with one centre word, no new G1 after it.)
G90 G0 H0 Z0
M6 T3 (TOOL 3, .5 END MILL
G90 G0 S8000 M3 E1 X-4.3 Y-2.3 (= rapid to X-4.3 Y-2.3)
H3 D3 Z.1 M8 (= rapid to Z.1)
G8
Z-.245 G1 F10. (= line to X-4.3 Y-2.3 Z-.245 feed 10)
X-4. G41 F50. (= line to X-4 Y-2.3 feed 50)
Y-2. (= line to X-4 Y-2)
I1. G2 (= arc cw center X-3 Y-2 radius 1 sweep 360 to X-4 Y-2 length 6.28319)
Y-1.7 (= line to X-4 Y-1.7)
X-4.3 G40 (= line to X-4.3 Y-1.7)
Y-2.3 Z-.25 (= line to X-4.3 Y-2.3 Z-.25)
G91
X.3 G41 (= line to X-4 Y-2.3)
Y.3 (= line to X-4 Y-2)
I1. G2 (= arc cw center X-3 Y-2 radius 1 sweep 360 to X-4 Y-2)
Y.3 (= line to X-4 Y-1.7)
X-.3 G40 (= line to X-4.3 Y-1.7)
M5 M9
G90 G0 H0 Z0
M2
