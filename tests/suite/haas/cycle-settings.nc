(machine: haas-vf2)
(set: settings."Setting 52"="0.1 in")
(set: settings."Setting 28"="off")
(set: settings."Setting 27"="Y-")
(Setting 52 lifts each return of G83, Setting 28 keeps a definition from drilling, 27 shifts to Y-.)
G20 G17 G90 G94 F10.
S1000 M3
G0 X0. Y0. Z1.
G83 G99 Z-.72 Q.4 R.1 (= none)
X1. (= rapid to X1 | rapid to Z.1 | line to Z-.3 | rapid to Z.2 | rapid to Z-.28 | line to Z-.7 | rapid to Z.2 | rapid to Z-.68 | line to Z-.72 | rapid to Z.1)
G80
G0 Z1.
G76 G98 X2. Z-.5 R.1 Q.02 (= rapid to X2 | rapid to Z.1 | line to Z-.5 | rapid to Y-.02 | rapid to Z1 | rapid to Y0)
G77 X3. Z-.5 R-1. Q.02 (= rapid to X3 | rapid to Y-.02 | rapid to Z-1 | rapid to Y0 | line to Z-.5 | rapid to Y-.02 | rapid to Z1 | rapid to Y0)
G84 X4. Z-.5 R.2 F50. J2. (= rapid to X4 | rapid to Z.2 | line to Z-.5 feed 50 | line to Z.2 feed 100 | rapid to Z1)
G80
M30
