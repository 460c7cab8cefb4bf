(machine: fadal-4020)
(Four lines name X where Y is meant: the arcs close on Z alone and drift along X.)
S1000 M3 D1
G90 X-5.09 Z-2. G0 Y0
G19
G91
Z-.56 G41 G1 F10. (= line to X-5.09 Z-2.56)
X1.6315 Z.942 (= line to X-3.4585 Z-1.618)
X.4657 Z.666 J-.48 K.8314 G3 (= helix ccw radius .96001..0.50770 to X-2.9928 Y0 Z-.952 | ! CH401 "0.4523 in")
X1.1328 Z.952 J1.1328 K-.198 G2 (= helix cw radius 1.1500..1.61423 to X-1.86 Y0 Z0 | ! CH401 "0.4643 in")
X1.86 (= line to X0 Z0)
Z.5 G0 G40
M2
