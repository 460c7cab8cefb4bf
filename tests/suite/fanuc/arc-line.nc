(machine: fanuc-30i)
(An arc code in force, an end point and no centre: a straight line by No. 3403#5 = 0, and a warning.)
G21 G17 G90 G94 S1000 M3
G0 X0. Y0.
G1 Z-1. F100.
G3 I-.5 (= arc ccw center X-.5 Y0 radius .5 sweep 360 to X0 Y0)
X-2.5 (= line to X-2.5 feed 100 | ! CH405 "straight line")
G2 X5. Y1. (= line to X5 Y1 | ! CH405 "neither a centre nor a radius: it is a straight line")
G18 G2 X6. Z-2. (= line to X6 Z-2 | ! CH405)
Z-3. (= line to Z-3 | ! CH405)
G17 G1 X7. (= line to X7)
M30
