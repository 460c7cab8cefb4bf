(machine: fanuc-30i)
(show: path)
(set: tools.1.diameter="10 mm")
(A neck of 8 before a chamber, and a tool of 10. No block turns round and the walls lie eight)
(blocks apart, so the control runs it in silence; the whole contour shows the gouge.)
G21 G17 G90 G40
T1 M6
S1000 M3
G0 X-30. Y-20.
F100.
G42 D1 G1 X-30. Y0. (= line to X-30 Y-5)
G1 X-4. (= line to X1 Y-5)
G1 Y20. (= line to X1 Y25 | ! CH530 "2 mm")
G1 X-20.
G1 Y50.
G1 X20. (= line to X15 Y45)
G1 Y20.
G1 X4.
G1 Y0. (= line to X-1 Y-5 | ! CH530 "2 mm")
G1 X30. (= line to X30 Y-5)
G40 G1 Y-20. (= line to X30 Y-20)
M30
