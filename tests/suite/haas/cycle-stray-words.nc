(machine: haas-vf2)
(A cycle takes its own letters alone; M16 is M6 by another number.)
T1 M16
G20 G17 G90 S1000 M3
G0 X0 Y0
G43 H1 Z1.
G81 X1. Z-.5 R.1 Q.2 F5. (= rapid to X1 | rapid to Z.1 | line to Z-.5 | rapid to Z1 | ! CH304 "`Q`")
G82 X2. Z-.5 R.1 P.5 K1. (= rapid to X2 | rapid to Z.1 | line to Z-.5 | dwell .5 | rapid to Z1 | ! CH304 "`K`")
G83 X3. Z-.5 R.1 Q.3
G80
M30
