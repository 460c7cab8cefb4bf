(machine: fanuc-6m)
(The radius form as printed: from Y.0003 the end is 2.2358 away, too far for a radius of 1.)
N001 G80 G90 G00 G98
N100 T01 M06
N101 G00 X-0.25 Y-0.25
N102 G44 Z-1. H01
N103 G01 Y3 (= line to Y.0003 | ! CH305 "0.0003 in" | ! CH406 | ! CH413)
N104 X2. (= line to X2 Y.0003)
N105 G17 G02 X3. Y2. R1. F7.2 (= line to X3 Y2 | ! CH402 "2.2358 in apart" "0.1179 in")
N106 G01 Y-0.25
N107 X-0.25
N108 G00Z0
N109 G49
N110 G91 G28 X0. Y0. Z0.
N110 M01
M30
