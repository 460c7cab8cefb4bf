(machine: fadal-4020)
(Half turns that go down, straight ramps between them. The second half turn has no G3: the)
(direction stays armed through the straight cut.)
S1000 M3 D1
G90 G0 X0 Y0 Z0 F20.
G91
Y.19 G41 G1
Y-.38 J-.19 G3 Z-.05 (= helix ccw center X0 Y0 radius .19 sweep 180 to X0 Y-.19 Z-.05)
X1. Z-.05 (= line to X1 Y-.19 Z-.1)
Y.38 J.19 Z-.05 (= helix ccw center X1 Y0 sweep 180 to X1 Y.19 Z-.15)
X-1. Z-.05 (= line to X0 Y.19 Z-.2)
Y-.38 J-.19 G3 (= arc ccw sweep 180 to X0 Y-.19 Z-.2)
X1.
Y.38 J.19 G3 (= arc ccw sweep 180 to X1 Y.19)
X-1. (= line to X0 Y.19)
Y-.19 G40 (= line to X0 Y0 Z-.2)
M2
