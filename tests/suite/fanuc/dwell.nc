(machine: fanuc-30i)
(Every form of G04: X and U in seconds with a point, in milliseconds without; P in milliseconds and without)
(a point; without a time it is an exact stop, after which the axes go on at once.)
(total: dwells 8)
G21 G17 G90 S1000 M3
G0 X0. Y0. Z0.
G04 X1.5 (= dwell 1.5)
G04 X1500 (= dwell 1.5)
G04 U1.25 (= dwell 1.25)
G04 U1250 (= dwell 1.25)
G04 P2500 (= dwell 2.5)
G1 X10. F500. (= line to X10)
G04 (= dwell 0)
Y10. (= line to Y10)
G04 P1.5 (= dwell .0015 | ! CH101 "decimal point" "PS0007" "read as 0.0015 s")
G20 G04 X1500 (= dwell 1.5)
M30
