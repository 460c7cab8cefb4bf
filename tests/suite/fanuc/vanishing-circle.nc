(machine: fanuc-30i)
(units: mm)
(An increment between start and end: hardly an arc. Said once.)
G21 G17 G90 G94 S1000 M3 F100
G0 X10. Y0. Z0.
G3 X10. Y.001 I-10. (= arc ccw sweep 0.00573 | ! CH446 "0.0057°" "0.001 mm")
G3 X10. Y.002 I-10. (= arc ccw sweep 0.00573)
(The other way it is nearly the circle that is meant, and a small radius makes a true arc.)
G1 X10. Y0.
G2 X10. Y.001 I-10. (= arc cw sweep 359.994)
G1 X0. Y0.
G3 X0. Y.1 I-10. (= arc ccw sweep 0.573)
M30
