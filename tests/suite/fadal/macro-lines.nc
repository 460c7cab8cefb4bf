(machine: fadal-4020)
(Macro lines: variables, registers, functions, comparisons, jumps, labels.)
S1000 M3
G90 G0 X0 Y0 Z0
G1 F20.
# V1=1.5 ' a remark
#V2=V1*2+1
N5 # R1=V2
N6 #R2 = V1
X+R1 Y-R2 (= line to X4 Y-1.5)
# R3=SIN(30)+COS(60)
X+R3. (= line to X1)
# R3=ATN(1)/10
X+R3 (= line to X4.5)
# R3=INT(-2.7)
X+R3 (= line to X-2)
# R3=SGN(0)+SGN(-5)*2+SGN(3)*4
X+R3 (= line to X3)
# R3=SQR(16)-ABS(-1.5)
X+R3 (= line to X2.5)
# SET RND3
# R3=RND(1.23456)
X+R3 (= line to X1.235)
#SET RADIANS
# R3=SIN(1.5707963267949)*2
#SET DEGREES
X+R3 (= line to X2)
# V3=2+3*4-10/5
# R3=V3
X+R3 (= line to X12)
# R3=-V1*-2
X+R3 (= line to X3)
'A remark line, and a loop: Y steps down three times.
#V10=0
#:AGAIN
#V10=V10+1
#R4=V10
Y+R4 (= line to Y1 | line to Y2 | line to Y3)
#IF V10<3 THEN GOTO :AGAIN
#IF V10=3 AND V1>1 THEN V11=7
#IF V10<>3 OR V1 LE 1 THEN V11=8
#IF NOT V10=4 THEN V12=V11+1
#R5=V12
X+R5 (= line to X8)
#GOTO N200
X99. (= none)
N200 X1. (= line to X1)
#GOTO:END
X98. (= none)
#:END
#:END
Y0 (= line to Y0)
# V20=V1=1.5 ' (= ! CH710)
M2
