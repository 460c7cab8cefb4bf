(machine: fanuc-0i)
(set: settings.length_at_reference_return="ended")
(set: work_offsets.G54.X="0 mm")
(set: work_offsets.G54.Y="0 mm")
(set: work_offsets.G54.Z="-400 mm")
(set: tools.1.length="100 mm")
(set: tools.2.length="150 mm")
(A return of Z to the reference point ends the length in force; one of X and Y does not.)
G21 G17 G40 G49 G80 G90
T2 M6
S1000 M3
G43 H2 Z50.
G28 X0 Y0
G1 Z8. F100.
G0 Z50.
G91 G28 Z0
G90
G0 G54 X0 Y0 S1000 M3
Z50. (= ! CH610 "the tip of tool 2 is 150 mm below")
G1 Z5. F100.
G0 Z50.
M30
