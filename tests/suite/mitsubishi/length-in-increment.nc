(machine: mitsubishi-m700)
(set: work_offsets.G54.X="0 mm")
(set: work_offsets.G54.Y="0 mm")
(set: work_offsets.G54.Z="0 mm")
(set: tools.1.length="-4 mm")
(In G91 the length is added to the way of Z: the machine goes from Z0 to Z-36.)
G21 G17 G40 G49 G80 G90
T1 M6
G53 G0 X0 Y0 Z0
G91 G43 G0 Z-32. H1 (= rapid to Z-32)
G90 G53 G0 Z-30. (= rapid to Z-26)
M30
