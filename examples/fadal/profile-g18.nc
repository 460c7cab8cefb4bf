(machine: fadal-4020)
(A profile in the XZ plane with two tangent arcs, cut with a ball end along the line of its centre.)
M6 T2 (BALL END MILL .25
G90 G0 S6000 M3 E1 X-5.09 Y0
H2 Z.5 M8
G18
Z-2. G0
Z-2.56 G1 F20.
X-3.4585 Z-1.618
X-2.9928 Z-.952 I-.48 K.8314 G2
X-1.86 Z0 I1.1328 K-.198 G3
X0
Z.5 G0
G17
M5 M9
G90 G0 H0 Z0
M2
