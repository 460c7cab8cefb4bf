(machine: fanuc-6m)
(The program as printed: no spindle, G01 before any F, Y3 without a point, and a centre of I2.)
(J-1. that is no centre: the radii are 2.2361 and 1, 333.4 degrees apart.)
N001 G80 G90 G00 G98
N100 T01 M06
N101 G00 X-0.25 Y-0.25
N102 G44 Z-1. H01
N103 G01 Y3 (= line to Y.0003 | ! CH305 "0.0003 in" | ! CH406 | ! CH413)
N104 X2.
Y3. (= line to X2 Y3)
N105 G17 G02 X3. Y2. I2. J-1. F7.2 (= arc cw center X4 Y2 radius 2.23607..1 sweep 333.435 | ! CH401 "1.2361 in" "PS0020")
N106 G01 Y-0.25
N107 X-0.25
N108 G00Z0
N109 G49
N110 G91 G28 X0. Y0. Z0.
N110 M01
M30
