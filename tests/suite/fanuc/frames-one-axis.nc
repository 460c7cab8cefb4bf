(machine: fanuc-30i)
(The first absolute block after G68, G69, G51 or G50 with one axis of the plane alone.)
G21 G17 G90 G94 S500 M3
G0 X10. Y0 Z10.
G68 X0 Y0 R90.
(The other axis is not what it was: it goes to X10 Y20.)
X20. (= rapid to X10 Y20 | ! CH439 "names X alone" "Y was 0 mm before it and is -10 mm now" "goes to X 10 mm, Y 20 mm")
(The next one is no longer the first.)
X30. (= rapid to X10 Y30)
G69
Y5. (= rapid to X10 Y5 | ! CH439 "names Y alone" "X was 30 mm before it and is 10 mm now")
(Both axes, or Z alone first.)
G68 X0 Y0 R90.
G0 Z20. (= rapid to Z20)
X20. Y0 (= rapid to X0 Y20)
X10. (= rapid to X0 Y10)
G69
G0 X0 Y0
(Without a centre, and about the present position, nothing changes.)
G68 R30.
X10. (= rapid to X8.660254 Y5)
G69
G0 X10. Y0
(The other axis does not change.)
G51 X0 Y0 P2.
X20. (= rapid to X40 Y0)
G50
G0 X10. Y10.
G51 X0 Y0 P2.
G1 X20. F100. (= line to X40 Y10 | ! CH439 "Y was 10 mm before it and is 5 mm now")
G50
(On and off without a move between.)
G0 X10. Y10.
G68 X0 Y0 R90.
G69
X20. (= rapid to X20 Y10)
(G91 first: what counts is the next absolute block.)
G68 X0 Y0 R90.
G91 X1. (= rapid to X20 Y11)
G90 X20. (= rapid to X20 Y20 | ! CH439 "Y was 10 mm")
G69
(A preset, or a move to a place of the machine, names the position anew.)
G92 X0 Y0
X5. (= rapid to X5 Y0)
G68 X0 Y0 R90.
G69
(A hole counts too.)
G0 X10. Y0
G68 X0 Y0 R90.
G81 X20. Z0 R15. F100. (= rapid to X10 Y20 | rapid to Z15 | line to Z0 | rapid to Z20 | ! CH439)
G80
G69
G0 X0 Y0
M30
