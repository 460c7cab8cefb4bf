(machine: fadal-4020)
(M45 here, a definition that does not fire, the bolt circle, the routine of G66.)
L100
G1 Z-.1 F10. (= line to Z-.1 x2)
G0 Z.5 (= rapid to Z.5 x2)
M17
M30
G20 G17 G90 F10.
S1000 M3
G0 X0 Y0 Z.5
G81 G99 Z-.2 R0+.1 (= none)
M45 (= rapid to Z.1 | line to Z-.2 | rapid to Z.1)
L9304 R1+1. R2+0 (= rapid to X1 Y0 | line to Z-.2 | rapid to Z.1 | rapid to X0 Y1 | line to Z-.2 | rapid to Z.1 | rapid to X-1 Y0 | line to Z-.2 | rapid to Z.1 | rapid to X0 Y-1 | line to Z-.2 | rapid to Z.1 | ! CH812 "1 in")
G91 Z-.5 (= none | ! CH817)
G90 G80
G0 Z.5
G66 L101 (= none)
X2. Y0 (= rapid to X2 Y0)
X3. (= rapid to X3)
G67
X4. (= rapid to X4)
M2
