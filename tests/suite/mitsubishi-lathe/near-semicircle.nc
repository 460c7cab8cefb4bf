(machine: mitsubishi-lathe)
(set: tools.1.offset.X="0 mm")
(set: tools.1.offset.Z="0 mm")
(Parameter 11028: a radius within two increments of half the chord has its centre in the middle.)
G21 G18 G40 G98
T0101
G97 S800 M3
G0 X20. Z0
G3 X20. Z-10. R5.001 F100. (= arc ccw radius 5 to X20 Z-10)
M30
