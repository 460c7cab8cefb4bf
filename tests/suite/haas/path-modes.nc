(machine: haas-vf2)
(Setting 85 is 0.025 in; G187 P1 uses all of it, P2 half, P3 a fifth; E names the distance itself.)
(Setting 191 is medium. The end of the program takes G187 back.)
O1
G20 G90 G94 S1000 M3
G1 X1. F40. (= line corner round .0125)
G187 P1
X2. (= line corner round .025)
G187 P3
X3. (= line corner round .005)
G187 P3 E.01
X4. (= line corner round .01)
G9 X5. (= line corner stop)
X6. (= line corner round .01)
G61
X7. (= line corner stop)
G64
X8. (= line corner round .01)
G187
X9. (= line corner round .0125)
G187 P4 (= ! CH303 "P4")
X10. (= line corner round .0125)
G187 E.002
M30
O2
G20 G90 G94 S1000 M3
G1 X1. F40. (= line corner round .0125)
M30
