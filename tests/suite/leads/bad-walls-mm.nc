(machine: fanuc-30i)
(show: path)
(set: tools.1.diameter="10 mm")
(set: tools.2.diameter="24 mm")
(Leads and walls that are cut, with a tool of 10 mm. Each is found, with its line.)
G21 G17 G40 G90
T1 M6
S1000 M3
F200.
(1 A neck of 8 between two chambers.)
G0 X-30. Y-20. Z5.
G1 Z-5.
G42 D1 X-30. Y0
X-4.
Y20. (= line | ! CH530 "2 mm")
X-20.
Y50.
X20.
Y20.
X4.
Y0 (= line | ! CH530 "2 mm")
X30.
G40 Y-20.
G0 Z5.
(2 A slot of 8 mm, its mouth open.)
G0 X0 Y30.
G1 Z-5.
G41 D1 X-4. Y20. (= ! CH531 "2 mm")
Y-20. (= ! CH530 "2 mm")
X4. (= ! CH508)
Y20.
G40 X0 Y30. (= ! CH531 "2 mm")
G0 Z5.
(3 An inside arc of 4.)
G0 X-30. Y20.
G1 Z-5.
G41 D1 X-30. Y0
X-4. (= ! CH530)
G3 X0 Y4. R4. (= ! CH507)
G1 Y40.
G40 X-20.
G0 Z5.
(4 The lead-in starts beyond the wall it leads to.)
G0 X0 Y-45.
G1 Z-5.
G41 D1 X0 Y-30. (= ! CH530)
X40.
Y30.
X-40.
Y-30.
X0
G40 Y0
G0 Z5.
(5 The lead-out goes through the far wall.)
G0 X0 Y0
G1 Z-5.
G41 D1 X0 Y-30.
X40.
Y30.
X-40.
Y-30.
X0
G40 Y50. (= ! CH530)
G0 Z5.
(6 The lead-out stops 2 mm before the far wall.)
G0 X0 Y0
G1 Z-5.
G41 D1 X0 Y-30.
X40.
Y30.
X-40.
Y-30.
X0
G40 Y28. (= ! CH530 "3 mm")
G0 Z5.
(7 The lead-in arc reaches into the wall at the side.)
G0 X20. Y0
G1 Z-5.
G42 D1 X43. Y-7. (= ! CH530 "3 mm")
G2 X20. Y-30. R23.
G1 X-40.
Y30.
X40.
Y-30.
X20.
G2 X-3. Y-7. R23.
G1 G40 X0 Y0
G0 Z5.
(8 The wrong side: the pocket is entered from its middle and run on its outside.)
G0 X0 Y0
G1 Z-5.
G42 D1 X0 Y-30. (= ! CH530 | ! CH534)
X40.
Y30.
X-40.
Y-30.
X0
G40 Y0 (= ! CH530)
G0 Z5.
(9 The wrong side of a bore rolled on from its centre.)
G0 X10. Y0
G1 Z-5.
G42 D1 X0 (= ! CH534)
G3 X25. Y0 R12.5 (= ! CH530)
G3 I-25.
G3 X0 Y0 R12.5 (= ! CH530)
G1 G40 X10.
G0 Z5.
(10 Growing offsets in a bore of 20: the last one does not fit.)
G0 X0 Y0
G1 Z-5.
G41 D1 X10.
G3 I-10.
G1 G40 X0
G41 D2 X10. (= ! CH530)
G3 I-10. (= ! CH507)
G1 G40 X0
G0 Z5.
M30
