(machine: fadal-4020)
(One centre word where the arc starts on an axis of its circle, end axes left out where they do)
(not change, words in any order. The circle of 1 about X2 Y1.)
S1000 M3
G90 G0 X3. Y1. Z0
G1 F20.
X2. Y2. I-1. G3 (= arc ccw center X2 Y1 radius 1 sweep 90 to X2 Y2)
Y0 J-1. G3 (= arc ccw center X2 Y1 radius 1 sweep 180 to X2 Y0)
G2 J1. Y2. (= arc cw center X2 Y1 radius 1 sweep 180 to X2 Y2)
J-1. G2 (= arc cw center X2 Y1 radius 1 sweep 360 to X2 Y2 length 6.28319)
G91 X-1. Y-1. J-1. G3 (= arc ccw center X2 Y1 radius 1 sweep 90 to X1 Y1)
X2. I1. (= arc ccw center X2 Y1 radius 1 sweep 180 to X3 Y1)
X-.5 (= line to X2.5 Y1)
X.5 (= line to X3 Y1)
I-1. (= arc ccw center X2 Y1 radius 1 sweep 360 to X3 Y1)
G90 X2. Y2. I-1. Z-.1 (= helix ccw center X2 Y1 sweep 90 to X2 Y2 Z-.1)
Y0 G2 (= line to X2 Y0 | ! CH405)
M2
