%
O30003 (SPACERS FROM BAR, PARTED, M97)
(machine: haas-lathe)
(set: settings.units="mm")
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.4 mm")
(set: tools.1.tip=3)
(set: tools.4.offset.X="-104 mm")
(set: tools.4.offset.Z="-54 mm")
(set: tools.5.offset.X="-105 mm")
(set: tools.5.offset.Z="-55 mm")
G21 G18 G40 G80 G99
T505 (DRILL 10)
G97 S1200 M03
G00 X0 Z4. M08
G83 Z-32. R1. Q6. F0.12
G80
G53 G00 X0 Z0
T101
G50 S3500
G97 S1500 M03
G00 X25. Z0
G96 S180
G01 X8. F0.12
G00 X24. Z1.
G01 Z-30. F0.2
X26.
G53 G00 X0 Z0
T404 (PART 3 WIDE)
G50 S2000
G97 S900 M03
G00 X28. Z-13.
M97 P100
G00 Z-26.
M97 P100
G53 G00 X0 M09
G53 G00 Z0
M30
N100 G96 S90
G01 X9. F0.07
G00 X28.
G97 S900
M99
%
