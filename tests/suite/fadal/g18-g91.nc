(machine: fadal-4020)
(The G18 profile in increments. The side is G41 as printed, which is the wrong one; without)
(compensation the path is the same. It closes on X0 Z0.)
S1000 M3 D1
G90 Y0 X-5.09 Z-2. G0
G18
G91
Z-.56 G41 G1 F10. (= line to X-5.09 Z-2.56 | ! CH534 "comes from the right")
X1.6315 Z.942 (= line to X-3.4585 Z-1.618)
X.4657 Z.666 I-.48 K.8314 G2 (= arc cw sweep 50.08 to X-2.9928 Z-.952 tangent .01)
X1.1328 Z.952 I1.1328 K-.198 G3 (= arc ccw sweep 80.09 to X-1.86 Z0 tangent .01)
X1.86 (= line to X0 Z0 tangent .01)
Z.5 G0 G40 (= rapid to Z.5)
M2
