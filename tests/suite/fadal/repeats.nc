(machine: fadal-4020)
(One helix three times: copied lines absolute and incremental, L3, and L3 with G91 before and)
(G90 behind the words: the words are read in increments, G90 holds from the next block on.)
S1000 M3 D1
G90 G0 X5. Y0 Z0 F10.
X5.5 G1 G41 (= line to X5.5)
I-.5 G3 Z-.1 (= helix ccw center X5 Y0 sweep 360 to X5.5 Z-.1)
I-.5 G3 Z-.2 (= helix ccw to X5.5 Z-.2)
I-.5 G3 Z-.3 (= helix ccw to X5.5 Z-.3)
X5. G40 (= line to X5)
Z0
G91
X.5 G1 G41 (= line to X5.5 Z0)
I-.5 G3 Z-.1
I-.5 G3 Z-.1
I-.5 G3 Z-.1 (= helix ccw center X5 Y0 to X5.5 Z-.3)
X-.5 G40
G90 Z0
G91 X.5 G1 G41 (= line to X5.5 Z0)
I-.5 G3 Z-.1 L3 (= helix ccw center X5 Y0 sweep 360 to X5.5 Z-.1 | helix to Z-.2 | helix to Z-.3)
X-.5 G40 (= line to X5 Z-.3)
G90 Z0 (= line to Z0)
X5.5 G1 G41 (= line to X5.5)
G91 I-.5 Z-.1 G90 L3 (= helix ccw center X5 Y0 sweep 360 to X5.5 Z-.1 | helix to Z-.2 | helix to Z-.3)
X5. G40 (= line to X5 Y0 Z-.3)
M2
