(machine: fadal-4020)
(Two arcs of one radius between the same ends, absolute and incremental. Half the chord over)
(the radius is .325/.75, so the short one turns 51.36 degrees and the long one the rest.)
S1000 M3
G90 G0 X2.973 Y-2.173 Z0
G1 F20.
X3.623 Y-2.173 R0+.75 G2 (= arc cw radius .75 sweep 51.36 to X3.623 Y-2.173)
X2.973 (= line to X2.973)
X3.623 Y-2.173 R0-.75 G2 (= arc cw radius .75 sweep 308.64 to X3.623 Y-2.173)
X2.973 (= line to X2.973 Y-2.173)
G91
X.65 Y0 R0+.75 G2 (= arc cw radius .75 sweep 51.36 to X3.623 Y-2.173)
X-.65 (= line to X2.973)
X.65 Y0 R0-.75 G2 (= arc cw radius .75 sweep 308.64 to X3.623 Y-2.173)
M2
