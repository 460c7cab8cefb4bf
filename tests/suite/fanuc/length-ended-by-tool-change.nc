(machine: fanuc-0i)
(set: settings.length_at_tool_change="ended")
(set: work_offsets.G54.X="0 mm")
(set: work_offsets.G54.Y="0 mm")
(set: work_offsets.G54.Z="-400 mm")
(set: tools.1.length="100 mm")
(set: tools.2.length="150 mm")
(A change of tools ends the length that G43 has brought into force before it.)
G21 G17 G40 G49 G80 G90
G43 H2
T2 M6
G0 G54 X0 Y0 S1000 M3
Z50. (= ! CH610 "the tip of tool 2 is 150 mm below")
G1 Z5. F100.
G0 Z50.
M30
