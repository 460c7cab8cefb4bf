(machine: fanuc-30i)
(G64 rounds corners without a figure of its own; G09 stops in its own block only; look-ahead modes have)
(the setting's 0.01 mm; an exact stop holds in them too.)
G21 G17 G90 G94 S1000 M3
G1 X10. F1000. (= line corner round)
G9 X20. (= line corner stop)
X30. (= line corner round)
G61 X40. (= line corner stop)
G9 X50. (= line corner stop)
X60. (= line corner stop)
G64 X70. (= line corner round)
G62 X80. (= line corner round)
G63 X90. (= line corner round)
G64
G5.1 Q1
X100. (= line corner round .01)
G9 X110. (= line corner stop)
X120. (= line corner round .01)
G61 X130. (= line corner stop)
G64 X140. (= line corner round .01)
G5.1 Q0
X150. (= line corner round)
G5 P10000
X160. (= line corner round .01)
G5 P0
X170. (= line corner round)
G8 P1
X180. (= line corner round .01)
G8 P0
X190. (= line corner round)
G5 P10001 (= ! CH306 "G5")
G9 G2 X200. I5. (= arc corner stop)
G2 X210. I5. (= arc corner round)
M30
