(machine: mitsubishi-m700-type2)
(Spirals of type 2: the turns follow from Q, else from the height word, else from L.)
G21 G17 G90 S1000 M3
G0 X100. Y0. Z0.
G1 F100.
G02 X40. I-100. Q30. L9 (= spiral cw center X0 Y0 radius 100..40 sweep 720 to X40 Y0)
G03 X100. I-40. L3 (= spiral ccw center X0 Y0 radius 40..100 sweep 720 to X100)
G02 X40. I-100. Z-20. K5. L9 (= spiral cw sweep 1440 to X40 Y0 Z-20)
G03 X100. Z0. I-40. Q20. K5. (= spiral ccw sweep 1080 to X100 Z0)
G02 X40. I-100. Q-30. (= spiral cw sweep 720)
G0 X100.
G02 X0 Y-50. I-100. L1 (= spiral cw radius 100..50 sweep 90)
G0 X100. Y0.
G02 X0 Y-50. I-100. Q40. (= spiral cw radius 100..50 sweep 450 to X0 Y-50)
G0 X100. Y0.
G02 X0 Y-50. I-100. Q30. (= spiral cw sweep 450 | ! CH410 "1.6667 turns" "1.25")
G0 X0. Y0. Z0.
G18
G02 Z20. K50. Q15. (= spiral cw plane zx center Z50 X0 radius 50..30 sweep 360 | ! CH410 "1.3333 turns" "P33")
G0 X0. Y0. Z0.
G02 Z20. K50. Q10. (= spiral cw plane zx radius 50..30 sweep 720 to X0 Z20)
G0 X0. Y0. Z0.
G02 Z20. Y10. K50. J5. (= spiral cw plane zx radius 50..30 sweep 720 to X0 Y10 Z20)
G17
G02.1 X5. I2. P1 (= line | ! CH411)
M30
