(machine: haas-vf2)
(set: settings.units="mm")
(set: spindle.max="3000 rpm")
(set: feed.max="3000 mm/min")
G21 G90 G17 G40 G49 G80 G94
T1 M6
G0 G54 X0 Y0
G43 H1 Z20.
(Nothing gives the spindle a speed.)
G84 X0 Y0 Z-15. R5. F750. (= ! CH819 "with tool 1, and the spindle has no speed")
G80
S2000
(Twice as fast on the way out.)
G84 X0 Y0 Z-15. R5. F2500. J2 (= ! CH606 "the way out of this tap turns the spindle at 4000 rpm, above the 3000 rpm")
G80
G95
(1.75 mm at 2000 rpm are 3500 mm/min.)
G84 X0 Y0 Z-15. R5. F1.75 (= ! CH407 "a feed of 3500 mm/min is above the 3000 mm/min")
G80
M30
