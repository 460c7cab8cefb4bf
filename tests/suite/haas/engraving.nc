(machine: haas-vf2)
(set: tools.1.length="100 mm")
(set: settings.units="mm")
(Engraving: to the start of the text and down, a time for the letters, and up; then X and Y are not known until they are named.)
G21 G17 G90 G94 G54
T1 M6
S5000 M3
G0 X0. Y0.
G43 H1 Z25.
G47 P0 X20. Y20. I45. J5. R2. Z-.2 F300. E100. (AB C) (= rapid to X20 Y20 Z25 | rapid to Z2 | line to Z-.2 | dwell 9 | rapid to Z2 | ! CH306 "the letters that G47 engraves are not followed")
G0 Z25. (= rapid to Z25)
G47 P1 X0. Y0. J5. R2. Z-.2 F600. (####) (= rapid to X0 Y0 | rapid to Z2 | line to Z-.2 feed 600 | dwell 6 | rapid to Z2 | ! CH306)
G0 Z25.
G47 P65 X30. Y0. J4. R2. Z-.2 F600. (= rapid to X30 Y0 | rapid to Z2 | line to Z-.2 | dwell 1.2 | rapid to Z2 | ! CH306)
G0 Z25. (= rapid)
G0 X1. Y1. (= rapid to X1 Y1)
G1 X5. (= line from X1 Y1 to X5)
M30
