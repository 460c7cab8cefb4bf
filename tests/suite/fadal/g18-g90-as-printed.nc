(machine: fadal-4020)
(A profile in G18. The end before the first arc is off by two swapped digits,)
(1.168 for 1.618, so the arc begins off its circle.)
S1000 M3 D1
G90 Y0 X-5.09 Z-2. G0
G18
Z-2.56 G42 G1 F10. (= line to X-5.09 Z-2.56)
X-3.4585Z-1.168 (= line to X-3.4585 Z-1.168)
X-2.9928 Z-.952 I-.48 K.8314 G2 (= arc cw center X-3.9385 Z-.3366 radius .96001..1.12830 | ! CH401 "0.1683 in" "0.0005 in" "BAD CIRCLE OR MISSING G")
X-1.86 Z0 I1.1328 K-.198 G3 (= arc ccw center X-1.86 Z-1.15 radius 1.1500..1.1500)
X0
Z.5 G0 G40
M2
