%
O9100
(= none | ! CH729 "called with V1 and R2")
(machine: fadal-4020)
#V3=V1/2
G1 X+R2 F10. (= none)
#R3=V3
Y+R3 (= none)
M99
%
