(machine: fadal-4020)
(G87 and G88 are in no page at hand: shown as boring in and out, and told.)
G20 G17 G90 F50.
S1000 M3
G0 X0 Y0 Z1.
G87 G98 X1. Z-.5 R0+.1 F50. (= rapid to X1 | rapid to Z.1 | line to Z-.5 | line to Z.1 | rapid to Z1 | ! CH812)
X2. (= rapid to X2 | rapid to Z.1 | line to Z-.5 | line to Z.1 | rapid to Z1)
G80
G88 G98 X3. Z-.5 R0+.1 F50. (= rapid to X3 | rapid to Z.1 | line to Z-.5 | line to Z.1 | rapid to Z1 | ! CH812 "G85")
G80
M2
