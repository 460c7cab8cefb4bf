(machine: fanuc-30i)
(show: path)
(set: tools.1.diameter="10 mm")
(A step of 3 up and a tool of 10: nothing is cut and this control runs it; the step's wall stays)
(partly uncut. Two controls alarm here.)
G21 G17 G90 G40
T1 M6
S1000 M3
G0 X-40. Y20.
F100.
G41 D1 G1 Y0. (= line to X-40 Y5)
G1 X0. (= line to X-5 Y5)
G1 Y3. (= line to X-5 Y8)
G1 X40. (= line to X40 Y8)
G40 G1 Y23. (= line to X40 Y23)
M30
