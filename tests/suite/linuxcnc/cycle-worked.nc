(machine: linuxcnc-mill)
(units: inch)
(Thirteen worked examples as rs274 runs them, every step with dwells and spindle.)
G20 G17 G90 G94 F10
S1000 M3
(E1: one hole, to the initial level.)
G0 X1 Y2 Z3
G90 G98 G81 X4 Y5 Z1.5 R2.8 (= rapid to X4 Y5 Z3 | rapid to X4 Y5 Z2.8 | line to Z1.5 feed 10 | rapid to Z3)
G80
(E2: three in G91, R above the initial level.)
G0 X1 Y2 Z3
G91 G98 G81 X4 Y5 Z-.6 R1.8 L3 (= rapid to X1 Y2 Z4.8 | rapid to X5 Y7 Z4.8 | line to Z4.2 | rapid to Z4.8 | rapid to X9 Y12 Z4.8 | line to Z4.2 | rapid to Z4.8 | rapid to X13 Y17 Z4.8 | line to Z4.2 | rapid to Z4.8)
G80
(E3 and E4: pecks.)
G90 G0 X0 Y0 Z1
G99 G73 X1 Y0 Z-1 R.1 Q.4 (= rapid to X1 Y0 Z1 | rapid to Z.1 | line to Z-.3 | rapid to Z-.29 | line to Z-.7 | rapid to Z-.69 | line to Z-1 | rapid to Z.1)
G80
G0 X0 Y0 Z1
G99 G83 X1 Y0 Z-1 R.1 Q.4 (= rapid to X1 Y0 Z1 | rapid to Z.1 | line to Z-.3 | rapid to Z.1 | rapid to Z-.29 | line to Z-.7 | rapid to Z.1 | rapid to Z-.69 | line to Z-1 | rapid to Z.1)
G80
(E5: a tap feeds out to the initial level.)
G0 X0 Y0 Z1
G98 G84 X1 Z-1 R.1 P.5 (= rapid to X1 Y0 Z1 | rapid to Z.1 | line to Z-1 | spindle off | spindle ccw | dwell .5 | line to Z1 | spindle off | spindle cw)
G80
(E6: back boring.)
G0 X0 Y0 Z1
G98 G87 X1 Y0 Z-1 R.1 I.1 J0 K-.5
(= rapid to X1 Y0 Z1 | rapid to Z.1 | rapid to X1.1 Y0 Z.1 | spindle off | spindle oriented | rapid to Z-1 | rapid to X1 Y0 Z-1 | spindle cw)
(= line to Z-.5 | line to Z-1 | spindle off | spindle oriented | rapid to X1.1 Y0 Z-1 | rapid to Z1 | rapid to X1 Y0 Z1 | spindle cw)
G80
(E7: from G99 to G98 the way to the second hole slopes.)
G0 X1 Y-.5 Z2
G81 G99 X1 Z-.5 R.1 (= rapid to Z.1 | line to Z-.5 | rapid to Z.1)
G98 X2 (= rapid to X2 Y-.5 Z2 | rapid to Z.1 | line to Z-.5 | rapid to Z2)
X4 (= rapid to X4 Y-.5 Z2 | rapid to Z.1 | line to Z-.5 | rapid to Z2)
G80
(E8: R is changed on the way.)
G0 X0 Y0 Z2
G99 G81 X1 Z-1 R.1 (= rapid to X1 Y0 Z2 | rapid to Z.1 | line to Z-1 | rapid to Z.1)
X2 R.5 (= rapid to X2 Y0 Z.5 | line to Z-1 | rapid to Z.5)
X3 R.1 (= rapid to X3 Y0 Z.5 | rapid to Z.1 | line to Z-1 | rapid to Z.1)
G80
(E9: G18 drills along Y.)
G0 X0 Y1 Z0
G18 G99 G81 X1 Z2 Y-1 R.1 (= rapid to X1 Y1 Z2 | rapid to X1 Y.1 Z2 | line to X1 Y-1 Z2 | rapid to Y.1)
G80 G17
(E10: from below R.)
G0 X0 Y0
G1 Z-.5
G98 G81 X1 Z-1 R.1 (= rapid to X0 Y0 Z.1 | rapid to X1 Y0 Z.1 | line to Z-1 | rapid to Z.1)
G80
(E11: words that stay are read again from the initial level.)
G0 X0 Y0 Z0
G91 G81 X1 Y0 Z-.5 R1 L4 (= rapid to X0 Y0 Z1 | rapid to X1 Y0 Z1 | line to Z.5 | rapid to Z1 | rapid to X2 | line to Z.5 | rapid to Z1 | rapid to X3 | line to Z.5 | rapid to Z1 | rapid to X4 | line to Z.5 | rapid to Z1)
X0 Y1 R0 L3 (= rapid to X4 Y1 Z1 | rapid to Z0 | line to Z-.5 | rapid to Z0 | rapid to X4 Y2 Z0 | line to Z-.5 | rapid to Z0 | rapid to X4 Y3 Z0 | line to Z-.5 | rapid to Z0)
G80
(E12: bores.)
G90 G0 X0 Y0 Z1
G98 G85 Z-1 R.1 (= rapid to Z.1 | line to Z-1 | line to Z.1 | rapid to Z1)
G86 Z-1 R.1 P.5 (= rapid to Z.1 | line to Z-1 | dwell .5 | spindle off | rapid to Z1 | spindle cw)
G89 Z-1 R.1 P.5 (= rapid to Z.1 | line to Z-1 | dwell .5 | line to Z1)
G80
(E13: G91 reads the levels of a cycle again.)
G0 X1 Y-1 Z1
G99 G81 Z-1.5 R.1 (= rapid to Z.1 | line to Z-1.5 | rapid to Z.1)
G91 X1 L2 (= rapid to X1 Y-1 Z1.1 | rapid to X2 Y-1 Z1.1 | line to Z-.4 | rapid to Z1.1 | rapid to X3 Y-1 Z1.1 | line to Z-.4 | rapid to Z1.1)
G80 G90
M2
