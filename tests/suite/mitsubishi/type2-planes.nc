(machine: mitsubishi-m700-type2)
(Cones of type 2 in the three planes. In G17 K is the height per turn, in G18 J, in G19 I; L counts)
(turns begun; a centre word left out is zero.)
G21 G17 G90 S1000 M3
G0 X50. Y0. Z0.
G1 F100.
G3 X10. Y0. Z20. I-50. K5. (= spiral ccw plane xy center X0 Y0 radius 50..10 sweep 1440 to X10 Y0 Z20)
G0 X0. Y0. Z0.
G18
G3 X0. Z20. Y12. K50. J4. (= spiral ccw plane zx center Z50 X0 radius 50..30 sweep 1080 to X0 Y12 Z20)
G0 X0. Y0. Z0.
G19
G2 Y20. Z0. X5. K-40. L2 (= spiral cw plane yz center Y0 Z-40 radius 40..44.7214 sweep 386.565 to X5 Y20 Z0)
G0 X0. Y0. Z0.
G3 Y20. Z0. X6. J50. I2. (= spiral ccw plane yz center Y50 Z0 radius 50..30 sweep 1080 to X6 Y20 Z0)
G0 X0. Y0. Z0.
G3 Y20. Z0. J50. I2. Q10. X6. (= spiral ccw plane yz radius 50..30 sweep 720 to X6 Y20)
G0 X0. Y0. Z0.
G17
(Without Q, L and K two radii are a spiral of less than a turn, as with L1.)
G2 X20. I50. (= line to X20 | ! CH410 "without L it makes no turn")
G0 X0. Y0.
G2 X20. Y10. I50. (= spiral cw plane xy center X50 Y0 radius 50..31.6228 sweep 18.4349 to X20 Y10)
G0 X0. Y0.
G3 X20. Y10. I50. Z4. (= spiral ccw plane xy center X50 Y0 radius 50..31.6228 sweep 341.565 to X20 Y10 Z4)
G0 X0. Y0. Z0.
(Radii that agree within 0.1 mm are an arc.)
G2 X50. Y50.08 I50. (= arc cw sweep 90 to X50 Y50.08)
G2 X30. L1 (= line to X30 | ! CH405 "P33")
G2 X40. R5. Q2. (= line to X40 | ! CH405 "P33")
M30
