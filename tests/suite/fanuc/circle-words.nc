(machine: fanuc-30i)
(Full circles with every word that a spiral may have, with a rotary axis, and by R.)
G21 G17 G90 S1000 M3
G0 X0 Y0 Z0
G1 F100.
G3 I-10. L1 (= arc ccw sweep 360 feed 100)
G3 I-10. L0 (= arc ccw sweep 360)
G3 I-10. K0 (= arc ccw sweep 360)
G3 I-10. K2. (= arc ccw sweep 360 | ! CH404 "K does not belong")
G3 I-10. L2 (= spiral ccw sweep 720)
G3 I-10. A90. (= arc ccw sweep 360 length 62.832 feed 100 | ! CH416 "does not turn it there")
(By R a full circle does not move, and neither does Z.)
G3 Z-1. R1. (= none | ! CH403 "nothing moves")
G1 X5. (= line from X0 Y0 Z0 to X5)
(On the ray of the start: L counts turns begun, so that exactly one is L1.)
G0 X100.
G2 X40. I-100. L1 (= spiral cw radius 100..40 sweep 360)
(Decimals below the increment are cut off; nine digits are too many.)
G1 X10.0019 (= line to X10.001)
G1 X1.23456789 (= line to X1.234 | ! CH311 "9 digits" "PS0003")
(Two codes of a group: the last one is used.)
G0 G1 X20. (= line to X20 | ! CH302 "uses the last one")
M30
