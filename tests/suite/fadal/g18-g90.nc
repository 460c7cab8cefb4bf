(machine: fadal-4020)
(The profile in G18 as it was meant. Sweeps and joints show that G2 turns clockwise seen)
(from +Y, as on every control: no further flip is made.)
S1000 M3 D1
G90 Y0 X-5.09 Z-2. G0
G18
Z-2.56 G42 G1 F10. (= line to X-5.09 Z-2.56)
X-3.4585 Z-1.618 (= line to X-3.4585 Z-1.618)
X-2.9928 Z-.952 I-.48 K.8314 G2 (= arc cw plane zx center X-3.9385 Z-.7866 radius .96001..0.96006 sweep 50.08 to X-2.9928 Z-.952 tangent .01)
X-1.86 Z0 I1.1328 K-.198 G3 (= arc ccw plane zx center X-1.86 Z-1.15 radius 1.1500..1.15 sweep 80.09 to X-1.86 Z0 tangent .01)
X0 (= line to X0 Z0 tangent .01)
Z.5 G0 G40 (= rapid to X0 Z.5)
M2
