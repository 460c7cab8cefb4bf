(machine: textbook-from-center)
(The reversed form as printed, which is the to-centre form again: I2. J-1. puts the centre at)
(X0, one above the start. From Y.0003 the radii are 2.23607 and 3.16218; from Y3. they are)
(2.23607 and 3.60555.)
N001 G80 G90 G00 G98
N100 T01 M06
N101 G00 X-0.25 Y-0.25
N102 G44 Z-1. H01
N103 G01 Y3 (= line to Y.0003 | ! CH305 "0.0003 in" | ! CH406 | ! CH413)
N104 X2. (= line to X2 Y.0003)
N105 G17 G02 X3. Y2. I2. J-1. F7.2 (= arc cw center X0 Y1.0003 radius 2.23607..3.16218 to X3 Y2 | ! CH401 "0.9261 in")
G01 X2. Y3. (= line to X2 Y3)
N105 G17 G02 X3. Y2. I2. J-1. F7.2 (= arc cw center X0 Y4 radius 2.23607..3.60555 sweep 7.125 | ! CH401 "1.3695 in")
N106 G01 Y-0.25
N107 X-0.25
N108 G00Z0
N109 G49
N110 G91 G28 X0. Y0. Z0.
N110 M01
M30
