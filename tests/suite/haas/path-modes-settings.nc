(machine: haas-vf2)
(set: settings."Setting 85" = "0.05 in")
(set: settings."Setting 191" = "finish")
(set: settings."G187 P3 part" = 0.1)
G20 G90 G94 S1000 M3
G1 X1. F40. (= line corner round .005)
G187 P1
X2. (= line corner round .05)
M30
