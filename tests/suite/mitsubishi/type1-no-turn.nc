(machine: mitsubishi-m700)
(Spirals of type 1 that make no turn: P counts whole turns, and without it there are none. What the)
(words leave is shown, and said.)
G21 G17 G90 S1000 M3
G0 X0 Y-45. Z0
G1 F500.
G02.1 Z-5. I0 J45. (= line to Z-5 | ! CH410 "without P it makes no turn")
G02.1 I0. J45. P0 (= none | ! CH410 "nothing moves")
G02.1 X0 Y-40. J45. P0 (= line to Y-40 | ! CH410 "one ray")
G0 X0 Y-45. Z0
G02.1 I0. J45. P1 (= arc cw sweep 360)
G02.1 I0. J45. P2 A10. (= spiral cw sweep 720 feed 500)
G02.1 X5. J45. K2. (= spiral cw | ! CH404 "K does not belong to G17")
G0 X0 Y-45.
G02.1 X0 Y0 J45. P1 (= spiral cw radius 45..0 sweep 360 | ! CH412 "the end of this spiral is its centre")
G0 X0 Y-45.
(An end before the ray of the start by no more than an increment: no turn more than P says.)
G02.1 X0.001 Y-40. J45. P2 (= spiral cw sweep 719.9986)
G0 X0 Y-45.
G02 J45. L2 (= arc cw sweep 360 | ! CH304 "#1272 ex08/bit2")
G02 J45. K2. (= arc cw sweep 360 | ! CH404)
G02 J45. K0 (= arc cw sweep 360)
M30
