(machine: haas-vf2)
(set: settings."G77 scheme"="shift-at-r")
(G77 as the manual's words have it: down at the centre, aside at R, up to Z, and back to the centre.)
G20 G17 G90 G94 F10.
S1000 M3
G0 X0. Y0. Z1.
G77 X3. Z-.5 R-1. Q.02 P100 (= rapid to X3 Z1 | rapid to Z-1 | spindle oriented | rapid to X3.02 Z-1 | spindle cw | line to X3.02 Z-.5 | dwell .1 | spindle oriented | rapid to X3 Z-.5 | rapid to Z1 | spindle cw)
G80
M30
