%
(machine: fadal-4020)
(V and R variables keep their values between programs.)
G90 G0 X0 Y0 Z0 S1000 M3
R1+2.
G1 X+R1 F10. (= line to X2)
#V1=3
#R2=V1
X+R2 (= line to X3)
X+R4 (= none | ! CH726 "V2 and R4" | ! CH727 "R4")
X4. (= line to X4)
#IF V2=1 THEN GOTO :END ' (= ! CH728 "V2")
X5. (= line to X5)
#:END
M2
%
