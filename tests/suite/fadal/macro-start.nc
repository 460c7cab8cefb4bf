%
O1 (START: another program, without a return; variables stay.)
(machine: fadal-4020)
G90 G0 X0 Y0 Z0
#V1=3
#IF V1>2 THEN START 2
X9. (= none)
M2
O2
#R1=V1
X+R1 (= rapid to X3)
M2
%
