(machine: haas-vf2)
(set: settings.units="mm")
(R is left out: a cycle feeds from where the tool is, as the manual's own example does.)
G21 G17 G90 G94 G54
G0 X0. Y0. Z5. S1000 M3
G84 Z-8.5 F500. (= line to Z-8.5 | spindle off | spindle ccw | line to Z5 | spindle off | spindle cw)
G80
G85 X5. Z-3. F100. (= rapid to X5 Z5 | line to Z-3 | line to Z5)
G80
M30
