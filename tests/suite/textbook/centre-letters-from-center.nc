(machine: textbook-from-center)
(The same slip, I typed as 1, in the reversed form and in the long form of the numbers.)
G90 G00 X2. Y3. Z0. S1000 M03
G01 F7.2
N120 G17 G02 X3.Y2. 10. J1. F7.2 (= arc cw center X2 Y2 radius 1 sweep 90 to X3 Y2 | ! CH102 "`10.`" "write `I0.`")
G00 X2. Y3.
N120 G17 G02 X3.Y2. 10.0000 J1.0000 F7.2 (= arc cw center X2 Y2 radius 1 sweep 90 to X3 Y2 | ! CH102 "`10.0000`" "write `I0.0000`")
G00 X2. Y3.
N120 G17 G02 X3.Y2. I0. J1. F7.2 (= arc cw center X2 Y2 radius 1 sweep 90 to X3 Y2)
M30
