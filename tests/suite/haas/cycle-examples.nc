(machine: haas-vf2)
G20 G17 G90 G94 F10.
S1000 M3
G0 X0. Y0. Z.1
G99 G91 G81 X1.25 Z-.3 L5 (= rapid to X1.25 | line to Z-.2 | rapid to Z.1 | rapid to X2.5 | line to Z-.2 | rapid to Z.1 | rapid to X3.75 | line to Z-.2 | rapid to Z.1 | rapid to X5 | line to Z-.2 | rapid to Z.1 | rapid to X6.25 | line to Z-.2 | rapid to Z.1)
G90 G80
G0 X1. Y-1. Z1.
G99 G81 Z-1.5 R.1 (= rapid to Z.1 | line to Z-1.5 | rapid to Z.1)
G91 X1. L2 (= rapid to X2 | line to Z-1.5 | rapid to Z.1 | rapid to X3 | line to Z-1.5 | rapid to Z.1)
G90 Y-2. (= rapid to Y-2 | line to Z-1.5 | rapid to Z.1)
G80
G0 X0. Y0. Z1.
G83 Z-.72 Q.175 R.1 (= rapid to Z.1 | line to Z-.075 | rapid to Z.1 | rapid to Z-.055 | line to Z-.25 | rapid to Z.1 | rapid to Z-.23 | line to Z-.425 | rapid to Z.1 | rapid to Z-.405 | line to Z-.6 | rapid to Z.1 | rapid to Z-.58 | line to Z-.72 | rapid to Z.1)
G80
G0 Z1.
G98 G73 Z-1. R.1 Q.2 K.4 (= rapid to Z.1 | line to Z-.1 | rapid to Z-.08 | line to Z-.3 | rapid to Z.1 | rapid to Z-.28 | line to Z-.5 | rapid to Z-.48 | line to Z-.7 | rapid to Z.1 | rapid to Z-.68 | line to Z-.9 | rapid to Z-.88 | line to Z-1 | rapid to Z1)
G80
G99 G83 Z-1. R.1 I.4 J.1 K.15 (= rapid to Z.1 | line to Z-.3 | rapid to Z.1 | rapid to Z-.28 | line to Z-.6 | rapid to Z.1 | rapid to Z-.58 | line to Z-.8 | rapid to Z.1 | rapid to Z-.78 | line to Z-.95 | rapid to Z.1 | rapid to Z-.93 | line to Z-1 | rapid to Z.1)
G80
G81 Z-1. R.1 L0 (= none)
G72 I.5 J30. L4 (= line to X0 Y0 Z-1 | rapid to Z.1 | rapid to X.4330127 Y.25 | line to Z-1 | rapid to Z.1 | rapid to X.8660254 Y.5 | line to Z-1 | rapid to Z.1 | rapid to X1.2990381 Y.75 | line to Z-1 | rapid to Z.1)
X0. Y0. L0 (= rapid to X0 Y0)
G71 I2. J30. K20. L4 (= rapid to X1.7320508 Y1 | line to Z-1 | rapid to Z.1 | rapid to X1.2855752 Y1.5320889 | line to Z-1 | rapid to Z.1 | rapid to X.6840403 Y1.8793852 | line to Z-1 | rapid to Z.1 | rapid to X0 Y2 | line to Z-1 | rapid to Z.1)
G80
G70 I1. J0. L4 (= none | ! CH807)
G81 Z.5 R.1 L1 (= line to Z.5 | rapid to Z.1 | ! CH805)
M30
