(machine: fanuc-30i)
(show: path)
(set: tools.1.diameter="10 mm")
(Corners, steps and islands that are cut, with a tool of 10 mm. Each is found, with its line.)
G21 G17 G40 G90
T1 M6
S1000 M3
F200.
(1 An island 8 mm from the wall of its pocket, in one offset.)
G0 X0 Y20. Z5.
G1 Z-5.
G41 D1 X-20. Y30.
X-40.
Y-30.
X40.
Y30. (= ! CH530 "2 mm")
X-20.
X22. Y0
G2 I5. (= ! CH530 "2 mm")
G1 G40 X0 Y20.
G0 Z5.
(2 A shallow inside corner with two blocks without a move in it.)
G0 X-20. Y20.
G1 Z-5.
G41 D1 X-20. Y0
X20. (= ! CH515 | ! CH530 "0.149 mm")
M8
G4 P100
X60. Y10.
G40 Y30.
G0 Z5.
(3 A bevel of 2.2 mm in an inside corner, shorter than the radius needs.)
G0 X-20. Y20.
G1 Z-5.
G41 D1 X-20. Y0
X0 (= ! CH530)
X2. Y1. (= ! CH508)
X3. Y10.
Y40.
G40 X-20.
G0 Z5.
(4 A notch of 6 in a wall.)
G0 X-20. Y20.
G1 Z-5.
G41 D1 X-20. Y0
X0
Y-10. (= ! CH530 "4 mm")
X6. (= ! CH508)
Y0 (= ! CH530 "4 mm")
X40.
G40 Y20.
G0 Z5.
(5 A V of 60 degrees with a flat floor of 4.)
G0 X-40. Y20.
G1 Z-5.
G41 D1 X-40. Y0
X-12.
X-2. Y-17.321 (= ! CH530)
X2. (= ! CH508)
X12. Y0
X40.
G40 Y20.
G0 Z5.
(6 Two bosses 8 mm apart, in one offset.)
G0 X-20. Y10.
G1 Z-5.
G41 D1 X0 Y10.
G2 I10. (= ! CH530 "2 mm")
G1 X-10. Y30.
X28. Y30.
Y10. (= ! CH530)
G2 I10. (= ! CH530 "2 mm")
G1 G40 Y40.
G0 Z5.
(7 Lead-in and wall: an open U of 30, entered through its side.)
G0 X-40. Y0
G1 Z-5.
G41 D1 X15. Y0 (= ! CH530)
Y20.
X-15.
Y-20.
G40 X0
G0 Z5.
(8 An open U of 30, left through its side.)
G0 X0 Y0
G1 Z-5.
G41 D1 X15. Y-20.
Y20.
X-15.
Y-20.
G40 X40. Y5. (= ! CH530)
G0 Z5.
(9 A pocket whose last wall crosses its first one.)
G0 X0 Y0
G1 Z-5.
G41 D1 X-45. Y-30. (= ! CH530)
X40.
Y30.
X-40.
Y-35. (= ! CH530)
G40 X0 Y0
G0 Z5.
(10 A pocket that goes round a boss too near to its lead.)
G0 X0 Y0
G1 Z-5.
G41 D1 X0 Y-30. (= ! CH530)
X40.
Y30.
X4.
Y-18.
X-4.
Y30.
X-40.
Y-30.
X0
G40 Y0 (= ! CH530)
G0 Z5.
M30
