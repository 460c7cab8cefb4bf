(machine: fadal-4020)
(Registers in any word: the sum R0+R1, centres, repeats; arrays and what the control tells.)
(set: tools.3.length = "-2.5 in")
(set: tools.3.diameter = "0.5 in")
(set: work_offsets.E2.X = "4 in")
S1000 M3
G90 G0 X0 Y0 Z0
G1 F20.
#R1=.5
X1. R0+R1 G2 (= arc cw center X.5 Y0 radius .5 sweep 180 to X1 Y0)
#R4=.25
G2 I-R4 (= arc cw center X.75 Y0 radius .25 sweep 360 to X1 Y0)
#R2=3
G91 X.1 G1 L+R2 (= line to X1.1 | line to X1.2 | line to X1.3)
G90
#V1=H3+D3
#R5=V1
Y+R5 (= line to Y-2)
#V10=2
#R5=FX(V10)
Y+R5 (= line to Y4)
#V(V10+1)=AX+AY
#R5=V3
Y+R5 (= line to Y5.3)
#R5=G(1)
X+R5 (= line to X2)
#R9=7
#TU(R9)=12
#R5=TU(R9)
X+R5 (= line to X12)
#R5=TU(8) ' (= ! CH719 "TU8")
X+R5 (= none | ! CH727 "TU8")
#CLEAR V1-V3,V10
#R5=V1+V2+V3+V10+1
X+R5 (= line to X1)
#R5=TL
X+R5 (= line to X0)
M2
