%
O0001
(machine: fanuc-0i)
(units: mm)
G21 G90 G17 G54
S1000 M3
G0 X0. Y0. Z0.
G1 X10. F200. (= line to X10)
G2 X20. I5. J0. (= arc to X20)
G1 X30. I5. J0. (= line to X30 | ! CH304 "I" | ! CH304 "J")
G3 X40. I5. J0. (= arc to X40)
G1 X50. Q5. (= line to X50 | ! CH304 "Q")
S1000 M3 M5 (= ! CH302 "M3 and M5 cannot be in one block")
S1000 M3
G43 H2001 Z5. (= ! CH303 "no H2001" | ! CH603)
M30
%
