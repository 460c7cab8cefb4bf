(machine: fadal-4020)
(The same profile in G19: the first axis is Y, so the senses are the other way round.)
S1000 M3 D1
G90 G0 X0 Y-5.09 Z-2.
G19
Z-2.56 G41 G1 F10. (= line to Y-5.09 Z-2.56)
Y-3.4585 Z-1.618 (= line to Y-3.4585 Z-1.618)
Y-2.9928 Z-.952 J-.48 K.8314 G3 (= arc ccw plane yz center Y-3.9385 Z-.7866 radius .96001..0.96006 sweep 50.08 to Y-2.9928 Z-.952 tangent .01)
Y-1.86 Z0 J1.1328K-.198 G2 (= arc cw plane yz center Y-1.86 Z-1.15 radius 1.1500..1.15 sweep 80.09 to Y-1.86 Z0 tangent .01)
Y0 (= line to Y0 Z0)
Z.5 G0 G40 (= rapid to Z.5)
M2
