(machine: mitsubishi-m700)
(P adds full turns to an arc: a quarter and two turns are 810 degrees, a rise of 10 over them a)
(lead of 10 x 360 / 810. An end left out or equal to the start is a full circle: P are all its turns.)
G21 G17 G90 S1000 M3
G0 X0. Y0. Z0.
G1 F100.
G2 X5. Y5. Z-10. I5. P2 (= helix cw center X5 Y0 radius 5 sweep 810 to X5 Y5 Z-10 length 71.3897)
G3 J-5. (= arc ccw center X5 Y0 radius 5 sweep 360 to X5 Y5)
G3 X5. Y5. J-5. P2 (= arc ccw center X5 Y0 radius 5 sweep 720 to X5 Y5 length 62.8319)
G2 X5. Y-5. R5. (= arc cw center X5 Y0 radius 5 sweep 180 to X5 Y-5)
G2 X5. Y5. R5. P2 (= arc cw center X5 Y0 sweep 180 to X5 Y5 | ! CH304 "`P`")
M30
