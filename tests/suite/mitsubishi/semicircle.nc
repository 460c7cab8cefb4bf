(machine: mitsubishi-m700)
(2R - chord up to 0.002 mm puts the centre in the middle of the chord; beyond it the radius)
(is taken as it stands, sqrt of 5.002 squared less 25 is 0.14146.)
G21 G17 G90 S1000 M3
G0 X0. Y0. Z0.
G1 F100.
G02 X10. R5.001 (= arc cw center X5 Y0 radius 5 sweep 180 to X10 Y0)
G0 X0.
G02 X10. R5.002 (= arc cw center X5 Y-.1414 radius 5.002 sweep 176.76 to X10 Y0)
M30
