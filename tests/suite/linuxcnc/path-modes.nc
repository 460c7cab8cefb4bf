(machine: linuxcnc-mill)
(G61 is exact without stops where the path is smooth, G61.1 stops; G64 names its tolerance or none.)
G20 G90 G94 S1000 M3
G1 X1 F40 (= line corner round)
G61 X2 (= line corner exact)
X3 (= line corner exact)
G61.1 X4 (= line corner stop)
G64 P.001 X5 (= line corner round .001)
X6 (= line corner round .001)
G64 P.002 Q.001 X7 (= line corner round .002 | ! CH306 "within 0.001 in")
G64 P.002 Q0 X7.5 (= line corner round .002)
G64 X8 (= line corner round)
M2
