%
O0901
(machine: fanuc-0i)
(set: work_offsets.G54.X = -200 mm)
(set: work_offsets.G54.Y = -200 mm)
(set: work_offsets.G54.Z = -300 mm)
(set: tools.1.length = 100 mm)
(set: tools.2.length = 200 mm)
(No length is in force: the tip of a tool of 200 mm is 200 mm below.)
G21 G17 G40 G49 G80 G90
T2 M6
G0 G54 X20. Y20. S3000 M3
Z25. (= ! CH610 "200 mm below the programmed point: no length offset is in force" "the tip goes to Z -175 mm")
G1 Z-5. F300.
G0 Z25.
M30
%
