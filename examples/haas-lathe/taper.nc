%
O30005 (MORSE TAPER IN PASSES, PIPE THREAD)
(machine: haas-lathe)
(set: settings.units="mm")
(set: tools.1.offset.X="-101 mm")
(set: tools.1.offset.Z="-51 mm")
(set: tools.1.nose_radius="0.8 mm")
(set: tools.1.tip=3)
(set: tools.7.offset.X="-107 mm")
(set: tools.7.offset.Z="-57 mm")
G21 G18 G40 G80 G99
T101
G50 S2000
G97 S900 M03
G00 X34. Z2. M08
G96 S180
G90 X31. Z-60. I-1.5 F0.2
X30.
X29.
G53 G00 X0 Z0
T707 (TAPERED THREAD)
G97 S400 M03
G00 X34. Z5.
G76 X24. Z-20. I-0.8 K1.1 D0.3 F1.814 A55
G53 G00 X0 M09
G53 G00 Z0
M30
%
