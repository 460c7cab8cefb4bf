(machine: fadal-4020)
(G2 and G3 leave G0 in force: what follows an arc is a rapid again, and that is said once.)
S1000 M3
G90 G0 X1. Y0 Z0 F10.
I-1. G3 (= arc ccw sweep 360 feed 10)
X2. (= rapid to X2 | ! CH417 "G0 is still active")
X3. (= rapid to X3)
G2 X4. (= rapid to X4 | ! CH405 "this control makes a rapid")
I-1. G3
G0 X5. (= rapid to X5)
G1 X6. (= line to X6)
I-1. G3
X7. (= line to X7)
(A full circle with a rotary axis: F is a length per minute.)
I-1. G3 A90. F10. (= arc ccw sweep 360 feed 10)
A180. F1000. (= line to A180 feed 1000)
M2
