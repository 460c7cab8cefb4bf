(machine: fanuc-30i)
(set: work_offsets.G54.X="0 mm")
(G53 is a rapid whatever motion is in force, and G1 is in force again after it.)
G21 G17 G90 S1000 M3
G0 X-10. Y0 Z0
G1 X-20. F100. (= line to X-20)
G53 X-30. (= rapid to X-30)
X-40. (= line to X-40)
M30
