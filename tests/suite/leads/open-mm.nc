(machine: mitsubishi-m700)
(set: tools.1.diameter="10 mm")
(Usual forms of entering and leaving open walls with a tool of 10 mm. Each is quiet.)
G21 G17 G40 G90
T1 M6
S1000 M3
F200.
(1 One wall; the tool comes from its side and goes off to it.)
G0 X0 Y20. Z5.
G1 Z-5.
G41 D1 X0 Y0
X100.
G40 Y20.
G0 Z5.
(2 One wall, quarter circles.)
G0 X-20. Y10.
G1 Z-5.
G41 D1 X-10. Y10.
G3 X0 Y0 R10.
G1 X100.
G3 X110. Y10. R10.
G1 G40 X120.
G0 Z5.
(3 A step with fillets, line and arc on, arc and line off.)
G0 X10. Y40.
G1 Z-5.
G41 D1 X-10. Y30.
G1 X-10. Y10.
G3 X0 Y0 R10.
G1 X40.
G3 X50. Y10. R10.
G1 Y30.
G2 X60. Y40. R10.
G1 X100.
G3 X110. Y50. R10.
G1 G40 Y70.
G0 Z5.
(4 Two walls at a corner, half circles on and off.)
G0 X30. Y10.
G1 Z-5.
G41 D1 X20. Y16.
G1 X0 Y16.
G3 X0 Y0 R8.
G1 X60.
Y60.
G3 X44. Y60. R8.
G1 G40 X30.
G0 Z5.
(5 The corner of two outside walls with a loop beyond it.)
G0 X0 Y20.
G1 Z-5.
G41 D1 X0 Y0
X100.
X110.
G3 X100. Y10. R-10.
G1 Y0
Y-60.
G40 X130.
G0 Z5.
(6 The finished wall beside the rough one, in one offset, with a way back above the part.)
G0 X-10. Y20.
G1 Z-5.
G41 D1 X-10. Y.5
X110.
G0 Z5.
Y40.
X-20.
Y0
G1 Z-5.
X110.
G40 Y20.
G0 Z5.
(7 There and back above the part between two depths.)
G0 X-10. Y20.
G1 Z-5.
G41 D1 X-10. Y0
X110.
G0 Z5.
X-10.
G1 Z-10.
X110.
G40 Y20.
G0 Z5.
(8 A convex arc: line on along the square, line off.)
G0 X-20. Y0
G1 Z-5.
G41 D1 X0 Y0
G2 X40. Y40. R40.
G1 G40 Y60.
G0 Z5.
(9 Down a ramp along the wall, back on the level.)
G0 X-10. Y20.
G1 Z0
G41 D1 X-10. Y0
X110. Z-5.
G40 Y20.
X-10.
G41 D1 X-10. Y0
X110.
G40 Y20.
G0 Z5.
M30
