(machine: fanuc-30i)
(set: settings.arc_mismatch = "arc-then-line")
(R beats the centre; a full circle by R does not move; within No. 3410 the arc goes on to the angle)
(of the end, then straight to it; above it is an alarm. Helices count F in the plane.)
G21 G17 G90 S1000 M3
G0 X0. Y0. Z0.
G1 F100.
G2 X10. R5. I3. (= arc cw center X5 Y0 radius 5 sweep 180 to X10 Y0 | ! CH409 "R is followed")
G3 X10. R5. (= none | ! CH403 "nothing moves")
G3 X0. R-5. (= arc ccw center X5 Y0 radius 5 sweep 180 to X0 Y0)
G2 X10.01 I5. (= arc cw radius 5 sweep 180 to X10 Y0 | line to X10.01 Y0 feed 100)
G0 X0.
G2 X10.02 I5. (= arc cw | ! CH401 "0.02 mm" "PS0020")
G0 X0.
G2 I5. Z-1. (= helix cw center X5 Y0 sweep 360 to X0 Z-1 along plane feed 100)
G2 I5. (= arc cw sweep 360 along path)
G2 X5. (= line to X5 | ! CH405 "a straight line")
G18 G3 X15. Z9. I10. (= arc ccw plane zx center Z-1 X15 radius 10 sweep 90 to X15 Z9)
G19 G2 Y10. Z-1. K-10. (= arc cw plane yz center Y0 Z-1 radius 10 sweep 90 to Y10 Z-1)
M30
