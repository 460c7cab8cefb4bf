(machine: fanuc-0i)
(set: work_offsets.G54.X="0 mm")
(set: work_offsets.G54.Y="0 mm")
(set: work_offsets.G54.Z="-300 mm")
(set: tools.1.length="100 mm")
(set: tools.2.length="150 mm")
(Lengths are all added or all subtracted: G44 after G43 puts the tip two lengths too low.)
G21 G17 G40 G49 G80 G90
T1 M6
G0 G54 X0 Y0 S1000 M3
G43 H1 Z50.
G1 Z10. F100.
G0 Z50.
G91 G28 Z0
G90
T2 M6
S1000 M3
G44 H2 Z50. (= ! CH610 "the tip of tool 2 is 300 mm below")
G1 Z5.
G0 Z50.
G49
M30
