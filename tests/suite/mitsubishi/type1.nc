(machine: mitsubishi-m700)
(Spirals of type 1: the angle of the ends and P full turns. The first is the manual's: from)
(radius 100 to 40 in exactly one turn, the second from 150 to 50 in three, as a cone.)
G21 G17 G90 S1000 M3
G0 X0. Y0. Z0.
G1 F100.
G91
G02.1 X60. Y0 I100. P1 F500. (= spiral cw center X100 Y0 radius 100..40 sweep 360 to X60 Y0 length 444.170 feed 500)
G90 G0 X0. Y0. Z0.
G91
G02.1 X100. Z150. I150. P3 (= spiral cw center X150 Y0 radius 150..50 sweep 1080 to X100 Y0 Z150 length 1894.392)
G90 G0 X0. Y0. Z0.
G03.1 X15. Y15. I0. J10. (= spiral ccw center X0 Y10 radius 10..15.8114 sweep 108.435 to X15 Y15)
G0 X0. Y0. Z0.
G18
G02.1 Z20. Y5. K50. P2 (= spiral cw plane zx center Z50 X0 radius 50..30 sweep 720 to X0 Y5 Z20)
G0 X0. Y0. Z0.
G19
G03.1 Y20. K-40. J0 (= spiral ccw plane yz center Y0 Z-40 radius 40..44.7214 sweep 333.435 to X0 Y20 Z0)
G17
G02.1 X5. Y5. R10. (= line to X5 Y5 | ! CH405 "P33")
G02.1 X9. Y9. I3. P100 (= spiral cw | ! CH303 "99")
M30
