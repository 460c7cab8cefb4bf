(machine: linuxcnc-mill)
(A structure that is not closed ends the run where its end is missed.)
G21 G90 G17
G0 X1
o1 if [0] (= ! CH712 "not closed")
X2 (= none)
M2
