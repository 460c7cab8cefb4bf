(machine: mitsubishi-m700)
(set: axes.C.max_velocity="36000 deg/min")
(The contour of the manual: on a mill X is a radius.)
G21 G17 G90 G94 S500 M3
G0 X40. Y0 Z0 C0
G12.1
G1 X20. F2000. (= line from X40 Y0 to X20 Y0)
C10. (= line to X20 Y10)
G3 X10. C20. R10. (= arc ccw to X10 Y20 center X10 Y10 radius 10.00)
G1 X-20. (= line to X-20 Y20)
C-10. (= line to X-20 Y-10)
G3 X-10. C-20. I10. J0 (= arc ccw to X-10 Y-20 center X-10 Y-10)
G1 X20. (= line to X20 Y-20)
C0 (= line to X20 Y0)
G12.1 (= none | ! CH443 "P486")
G7.1 C20. (= none | ! CH443 "P486")
G43 H1 (= none | ! CH442 "P481")
Y5. (= none | ! CH312 "Y itself moves")
G13.1
G0 Z1. (= rapid from X20 Y0 Z0 C360)
(A cylinder about X.)
G0 X0 A0
G7.1 A50.
G1 X30. A60. F500. (= line to X30 Y52.3598775598 length 60.35)
G3 X50. A82.918312 R20. (= arc ccw plane xy radius 20.00 sweep 90.00)
G7.1 A0
G17 G7.1 A50. (= ! CH443 "alone in its block" "P33")
G7.1 A0
(F by the revolution does not act on a face: there it is by the minute, and needs one of its own.)
G95 G1 X40. F.1
G12.1
X39. (= ! CH406 | line)
X38. F500. (= line feed 500)
G13.1
X37. (= line)
M30
