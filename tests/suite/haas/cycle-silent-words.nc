(machine: haas-vf2)
(E throws chips off after G81 to G84; other cycles do not take it.)
G20 G17 G90 G94 F10.
S1000 M3
G0 X0. Y0. Z1.
G76 G98 X2. Z-.5 R.1 Q.02 E500 (= ! CH304 "`E`")
G85 G98 X3. Z-.5 R.1 E500 (= rapid to X3 | rapid to Z.1 | line to Z-.5 | line to Z.1 | rapid to Z1 | ! CH304 "`E`")
G81 X4. Z-.5 R.1 E500 (= rapid to X4 | rapid to Z.1 | line to Z-.5 | rapid to Z1 | spindle ccw | spindle cw)
G80
M30
