%
O0901
(machine: mitsubishi-m700)
(set: work_offsets.G54.X = -200 mm)
(set: work_offsets.G54.Y = -200 mm)
(set: work_offsets.G54.Z = -300 mm)
(set: tools.1.length = 100 mm)
(set: tools.2.length = 200 mm)
(The length of tool 1 stays in force for tool 2, which is 100 mm longer.)
G21 G17 G40 G49 G80 G90
T1 M6
G0 G54 X20. Y20. S3000 M3
G43 H1 Z25.
G1 Z-5. F300.
G0 Z200.
T2 M6
G0 X30. Y20. S3000 M3
Z125.
Z25. (= ! CH610 "tool 2 is 100 mm below the programmed point: length offset 1 is in force" "tool 2 is 200 mm long, offset 1 is 100 mm")
G1 Z-5. F300.
G0 Z200.
M30
%
