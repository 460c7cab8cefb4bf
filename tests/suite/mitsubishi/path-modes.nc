(machine: mitsubishi-m700)
(G61.1 is high-accuracy control, with the setting's 0.01 mm at corners; G09 stops in its block only.)
G21 G17 G90 G94 S1000 M3
G1 X10. F1000. (= line corner round)
G9 X20. (= line corner stop)
X30. (= line corner round)
G61 X40. (= line corner stop)
G61.1 X50. (= line corner round .01)
G9 X60. (= line corner stop)
X70. (= line corner round .01)
G64 X80. (= line corner round)
G62 X90. (= line corner round)
G63 X100. (= line corner round)
G64
G5.1 Q1
X110. (= line corner round .01)
G5.1 Q0
X120. (= line corner round)
G5 P10000
X130. (= line corner round .01)
G5 P0
X140. (= line corner round)
G8 P1
X150. (= line corner round .01)
G8 P0
X160. (= line corner round)
M30
