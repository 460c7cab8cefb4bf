(machine: fadal-4020)
G20 G17 G90 F50.
S1000 M3
G0 X0 Y0 Z1.
G81 G98 Z-.1 R0+.1 F50. M45 (= rapid to Z.1 | line to Z-.1 | rapid to Z1)
G91 X.5 L2 (= rapid to X.5 | rapid to Z.1 | line to Z-.1 | rapid to Z1 | rapid to X1 | rapid to Z.1 | line to Z-.1 | rapid to Z1)
G90 G0 X3. (= rapid to X3 | rapid to Z.1 | line to Z-.1 | rapid to Z1)
G80
G81 G99 X2. Y-3. Z-.2 R0+.1 (= rapid to X2 Y-3 | rapid to Z.1 | line to Z-.2 | rapid to Z.1)
G80
G0 Z1.
G84 X1. Y0 Z-.5 R0+.1 Q.05 F400. (= rapid to X1 Y0 | rapid to Z.1 | line to Z-.5 feed 20 | line to Z.1 feed 20)
G80
G0 Z1.
G84 X1. Z-.5 R0+.1 F400. (= none | ! CH804)
G80
G81 X1. Z-.5 R0+2. F10. (= none | ! CH805)
G80
M2
