(machine: fanuc-6m)
(The letter I read as the digit 1. Without it the centre words mean another centre, and say so.)
G90 G00 X2. Y3. Z0. S1000 M03
G01 F7.2
N120 G17 G02 X3.Y2. 12. J2. (= arc cw to X3 Y2 | ! CH102 "`12.`" "write `I2.`" | ! CH401)
G00 X2. Y3.
N120 G17 G02 X3.Y2. 10. J-1. (= arc cw center X2 Y2 radius 1 sweep 90 | ! CH102 "write `I0.`")
G00 X2. Y3.
N120 G17 G02 X3.Y2. I0. J-1. (= arc cw center X2 Y2 radius 1 sweep 90)
G00 X2. Y3.
N120 G17 G02 X3.Y2. I2. J2. (= arc cw center X4 Y5 radius 2.82843..3.16228 | ! CH401 "0.3339 in" "as the centre's coordinates")
M30
