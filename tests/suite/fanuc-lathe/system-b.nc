(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(set: settings."No. 3401"="B")
G21 G18 G40 G80
G92 S3000
T0101
G97 S800 M3
G0 G90 X66. Z2. (= rapid to X66 Z2)
G91 X-2. Z-1. (= rapid to X64 Z1)
G90
G95 F.25
G0 X66. Z2.
G77 X60. Z-40. (= rapid to X60 Z2 | line to X60 Z-40 | line to X66 Z-40 | rapid to X66 Z2)
G79 X20. Z-2. F.2 (= rapid to X66 Z-2 | line to X20 Z-2 | line to X20 Z2 | rapid to X66 Z2)
G0 X28. Z6.
G78 X23.2 Z-25. F3. (= rapid to X23.2 Z6 | line to X23.2 Z-22 | line to X28 Z-24.4 | rapid to X28 Z-25 | rapid to X28 Z6)
G33 Z-20. F2. (= line to X28 Z-20)
G94 F100.
G0 X0 Z5.
(G99: the holes end at R.)
G99 G83 Z-10. R-3. F50. (= rapid to X0 Z2 | line to X0 Z-10 | rapid to X0 Z2)
G80
G32 Z-20. F2. (= ! CH301)
M30
