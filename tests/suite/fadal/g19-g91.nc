(machine: fadal-4020)
(The incremental G19 profile with Y where it belongs.)
S1000 M3 D1
G90 Y-5.09 Z-2. G0 X0
G19
G91
Z-.56 G41 G1 F10. (= line to Y-5.09 Z-2.56)
Y1.6315 Z.942 (= line to Y-3.4585 Z-1.618)
Y.4657 Z.666 J-.48 K.8314 G3 (= arc ccw sweep 50.08 to X0 Y-2.9928 Z-.952 tangent .01)
Y1.1328 Z.952 J1.1328 K-.198 G2 (= arc cw sweep 80.09 to X0 Y-1.86 Z0 tangent .01)
Y1.86 (= line to Y0 Z0)
Z.5 G0 G40
M2
