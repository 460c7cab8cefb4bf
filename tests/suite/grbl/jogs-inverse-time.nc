(machine: grbl)
(A jog has its own feed and modes. In inverse time a line takes its time, and an arc runs at F times its segments.)
G21 G90 G17 G94 F100
$J=X10 F300 (= line to X10 feed 300)
$J=G91 X5 F600 (= line to X15 feed 600)
G1 X20 (= line to X20 feed 100)
$J=G20 G53 X0 F10 (= line to X0 feed 254)
G0 X1 (= rapid to X1)
G0 X0
G93
G1 X10 F30 (= line to X10)
G2 X30 Y0 I10 F30 (= arc cw radius 10.0 feed 2340 | ! CH445 "78 segments")
G3 X10 I-10 F30 (= arc ccw radius 10.0 feed 2340)
G94
M2
