(machine: linuxcnc-mill)
(units: mm)
(Steps of the cycles, as rs274 makes them.)
G21 G17 G90 G94 F10
S1000 M3
G0 X1 Y2 Z3
G90 G98 G81 X4 Y5 Z1.5 R2.8 (= rapid to X4 Y5 Z3 | rapid to Z2.8 | line to Z1.5 feed 10 | rapid to Z3)
G80
G0 X1 Y2 Z3
G91 G98 G81 X4 Y5 Z-.6 R1.8 L3 (= rapid to X1 Y2 Z4.8 | rapid to X5 Y7 Z4.8 | line to Z4.2 | rapid to Z4.8 | rapid to X9 Y12 | line to Z4.2 | rapid to Z4.8 | rapid to X13 Y17 | line to Z4.2 | rapid to Z4.8)
G80
G90 G0 X0 Y0 Z1
G99 G73 X1 Y0 Z-1 R.1 Q.4 (= rapid to X1 Y0 Z1 | rapid to Z.1 | line to Z-.3 | rapid to Z-.046 | line to Z-.7 | rapid to Z-.446 | line to Z-1 | rapid to Z.1)
G80
G0 Z1
G98 G84 X1 Z-1 R.1 P.5 (= rapid to Z.1 | line to Z-1 | line to Z1)
G80
G0 X0
G98 G87 X1 Y0 Z-1 R.1 I.1 J0 K-.5 (= rapid to X1 Z1 | rapid to Z.1 | rapid to X1.1 Z.1 | rapid to Z-1 | rapid to X1 Z-1 | line to Z-.5 | line to Z-1 | rapid to X1.1 Z-1 | rapid to Z1 | rapid to X1 Z1)
G80
G0 X0 Y1 Z0
G18 G99 G81 X1 Z2 Y-1 R.1 (= rapid to X1 Y1 Z2 | rapid to Y.1 | line to Y-1 | rapid to Y.1)
G80
M2
