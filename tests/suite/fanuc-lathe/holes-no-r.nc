(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(R is left out: the feed begins where the tool is. M29 prepares rigid tapping.)
G21 G18 G40 G99
T0101
G97 S800 M3
G0 X0. Z5.
M29 S500 (= none)
G84 Z-8.5 F1. (= line to Z-8.5 | spindle off | spindle ccw | line to Z5 | spindle off | spindle cw)
G80
G85 Z-3. F.1 (= line to Z-3 | line to Z5)
G80
M30
