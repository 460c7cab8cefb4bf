%
(machine: grblhal)
(set: settings."on error"="continue")
(A refused block changes nothing; the numbers are those of GRBL 1.1 and further ones.)
G21 G90 G17 G94
G1 X10 (= ! CH313 "no feed")
G0 X5 Z10 (= rapid to X5 Z10)
F120
G81 X10 Z-3 (= ! CH313 "is missing: R and Z")
G81 X10 Z-3 R2 L0 (= ! CH313 "must be above zero")
G81 X10 Z3 R2 (= ! CH313 "R is 1 mm below it")
G83 X10 Z-3 R2 (= ! CH313 "is missing: Q")
G82 X10 Z-3 R2 (= ! CH313 "is missing: P")
X6 (= rapid to X6)
G43 H1 (= ! CH313 "does not have this word")
G65 P100 (= ! CH313 "does not have this word")
G41 D1 (= ! CH313 "does not have this word")
G33 Z-1 K1 (= ! CH313 "does not have this word")
A5 (= ! CH313 "does not have this word")
G18 G5 X1 Y1 I1 J1 P-1 Q1 (= ! CH313 "needs the plane XY")
G5 X1 Y1 P-1 Q1 (= ! CH313 "needs is missing")
M61 (= ! CH313 "needs is missing")
G10 L1 P1 Z5 (= ! CH313 "does not have this word")
G10 L2 P10 X1 (= ! CH313 "does not have a work offset")
#1=5 (= ! CH313 "begins with a letter")
G0 X0 (= rapid to X0)
M2
%
