%
O30006 (PLATE: CENTRE, DRILL, BORE AND TAP ON THE AXIS)
(machine: haas-lathe)
(set: settings.units="mm")
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.5.offset.X="-105 mm")
(set: tools.5.offset.Z="-55 mm")
(set: tools.6.offset.X="-106 mm")
(set: tools.6.offset.Z="-56 mm")
(set: tools.8.offset.X="-108 mm")
(set: tools.8.offset.Z="-58 mm")
(set: tools.9.offset.X="-109 mm")
(set: tools.9.offset.Z="-59 mm")
G21 G18 G40 G80 G99
T101
G97 S500 M03
G00 X84. Z0 M08
G96 S200
G50 S1500
G01 X-1. F0.2
G53 G00 X0 Z0
T505 (CENTRE DRILL)
G97 S1500 M03
G00 X0 Z5.
G82 Z-4. R2. P200 F0.08
G80
G53 G00 X0 Z0
T606 (DRILL 8.5)
G97 S1200 M03
G00 X0 Z5.
G83 Z-25. R2. Q5. F0.12
G80
G53 G00 X0 Z0
T808 (REAMER)
G97 S300 M03
G00 X0 Z5.
G85 Z-20. R2. F0.2
G80
G53 G00 X0 Z0
T909 (TAP M10)
G97 S300 M03
G00 X0 Z8.
G84 Z-18. R5. F1.5
G80
G53 G00 X0 M09
G53 G00 Z0
M30
%
