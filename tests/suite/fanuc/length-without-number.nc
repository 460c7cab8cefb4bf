(machine: fanuc-0i)
(set: work_offsets.G54.X="0 mm")
(set: work_offsets.G54.Y="0 mm")
(set: work_offsets.G54.Z="-400 mm")
(set: tools.1.length="100 mm")
(set: tools.2.length="150 mm")
(G43 without H takes the H that is in force; at power-on that is H0.)
G21 G17 G40 G49 G80 G90
T1 M6
G0 G54 X0 Y0 S1000 M3
G43 Z50. (= ! CH308 "H0, and no length acts" | ! CH610 "the tip of tool 1 is 100 mm below")
G1 Z10. F100.
G0 Z50.
G43 H1 Z50.
G1 Z5.
G0 Z50.
T2 M6
S1000 M3
G43 Z50.
G1 Z5. (= ! CH610 "the tip of tool 2 is 50 mm below")
G0 Z50.
G43 H2 Z50.
G43
G1 Z5.
M30
