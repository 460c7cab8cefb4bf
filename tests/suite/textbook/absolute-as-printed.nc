(machine: textbook-absolute-center)
(The absolute form as printed. The centre is right; Y3 without a point stops three ten-thousandths)
(above the edge, so the arc starts 1.9997 from its centre. No spindle, no feed before the first cut.)
N001 G80 G90 G00 G98
N100 T01 M06
N101 G00 X-0.25 Y-0.25 (= rapid to X-.25 Y-.25)
N102 G44 Z-1. H01 (= rapid to Z-1)
N103 G01 Y3 (= line to X-.25 Y.0003 Z-1 | ! CH305 "0.0003 in" | ! CH406 | ! CH413)
N104 X2. (= line to X2 Y.0003)
N105 G17 G02 X3. Y2. I2. J2. F7.2 (= arc cw center X2 Y2 radius 1.9997..1 sweep 270 to X3 Y2 | ! CH401 "0.9997 in")
N106 G01 Y-0.25 (= line to X3 Y-.25)
N107 X-0.25 (= line to X-.25 Y-.25)
N108 G00Z0 (= rapid to Z0)
N109 G49
N110 G91 G28 X0. Y0. Z0.
N110 M01
M30
