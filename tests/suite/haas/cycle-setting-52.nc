(machine: haas-vf2)
(set: settings."Setting 52"="0.1 in")
(set: settings."Setting 130"=2)
(Setting 52: each return between pecks goes .1 above R; Setting 130: a tap leaves twice as fast.)
G20 G17 G90 G94 F10.
S1000 M3
G0 X0. Y0. Z1.
G99 G83 Z-.72 Q.175 R.1 (= rapid to Z.1 | line to Z-.075 | rapid to Z.2 | rapid to Z-.055 | line to Z-.25 | rapid to Z.2 | rapid to Z-.23 | line to Z-.425 | rapid to Z.2 | rapid to Z-.405 | line to Z-.6 | rapid to Z.2 | rapid to Z-.58 | line to Z-.72 | rapid to Z.1)
G80
S900 M5
G84 X1. Z-.5 R.1 F56.25 (= rapid to X1 | spindle cw | line to Z-.5 feed 56.25 | spindle off | spindle ccw | line to Z.1 feed 112.5 | spindle off)
G80
M30
