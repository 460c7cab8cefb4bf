(machine: mitsubishi-m700-type2)
(Full circles with the words of spirals: K0, L0 and L1 leave them what they are without.)
G21 G17 G90 S1000 M3
G0 X0 Y-45. Z0
G1 F500.
G02 I0. J45. K0 F500. (= arc cw center X0 Y0 radius 45 sweep 360 to X0 Y-45 length 282.743 feed 500)
G02 I0. J45. L0 (= arc cw sweep 360)
G02 I0. J45. L1 (= arc cw sweep 360)
G02 I0. J45. Q0 (= arc cw sweep 360)
(A helix: the length is the root of 282.743 and 5 squared.)
G02 X0. Y-45. Z-5. I0. J45. K0 (= helix cw sweep 360 to X0 Y-45 Z-5 length 282.788)
G02 I0. J45. L2 (= spiral cw sweep 720 length 565.487)
G02 I0. J45. Q2. (= arc cw sweep 360 | ! CH410 "equally far")
G02 I0. J45. K2. (= arc cw sweep 360 | ! CH410 "as high as")
G02 Z-15. I0. J45. K5. (= spiral cw sweep 720 to Z-15)
(Open spirals: a word of zero is read as L1, and that is said.)
G0 X0 Y-45. Z0
G02 X40. Y0 J45. K0 (= spiral cw radius 45..40 sweep 270 | ! CH410 "`K` of zero")
G0 X0 Y-45. Z0
G02 X40. Y0 J45. L0 (= spiral cw sweep 270 | ! CH410 "`L` of zero")
G0 X0 Y-45. Z0
G02 X0 Y-40. J45. L1 (= line to X0 Y-40 | ! CH410 "one ray")
G0 X0 Y-45. Z0
G02 X0 Y-40. J45. L2 P3 (= spiral cw radius 45..40 sweep 360 | ! CH304 "`P`")
G0 X0 Y-45. Z0
G02.0 I0 J45. (= arc cw sweep 360 | ! CH411 "a spiral is G2.1")
(With a rotary axis F stays a length per minute.)
G02 I0 J45. A90. F500. (= arc cw sweep 360 feed 500)
M30
