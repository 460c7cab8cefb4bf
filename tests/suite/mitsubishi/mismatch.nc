(machine: mitsubishi-m700)
(RadErr is 0.100 mm: 9.899 is off by more, 9.9 is not and is reached by a spiral.)
G21 G17 G90 S1000 M3
G0 X0. Y0. Z0.
G1 F100.
G91 G02 X9.899 I5. (= arc cw radius 5..4.899 sweep 180 to X9.899 | ! CH401 "0.101 mm" "0.1 mm" "P70")
G90 G0 X0.
G91 G02 X9.9 I5. (= arc cw radius 5..4.9 sweep 180 to X9.9 Y0)
M30
