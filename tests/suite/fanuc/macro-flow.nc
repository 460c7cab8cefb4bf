%
O0001 (MACRO B: GOTO, IF, WHILE)
(machine: fanuc-30i)
(units: mm)
N1 G21 G90 G17 G94 S1000 M3 F100. G0 X0 Y0
#1=1
(Tested before the first pass.)
WHILE[#1LE3]DO1
#2=1
WHILE [ #2 LE 2 ] DO2
X[#1*10] Y#2 (= rapid to X10 Y1 | rapid to X10 Y2 | rapid to X20 Y1 | rapid to X20 Y2 | rapid to X30 Y1 | rapid to X30 Y2)
#2=#2+1
END2
#1=#1+1
END1
WHILE[#1LT0]DO1
X999. (= none)
END1
(Numbers may be used again, in any order; GOTO leaves a loop.)
#1=0
DO2
WHILE[1EQ1]DO1
#1=#1+1
IF[#1GE4]GOTO50
X#1 (= rapid to X1 | rapid to X2 | rapid to X3)
END1
END2
N50 X50. (= rapid to X50)
(GOTO looks below first, then from the top.)
#10=51
#1=0
N61 #1=#1+1
IF[#1EQ1]THEN #11=7.
IF[#1EQ2]THEN #11=8.
X#11 (= rapid to X7 | rapid to X8)
IF[#1LT2]GOTO[#10+10]
N62 GOTO62
X999. (= none)
N62 X62. (= rapid to X62)
GOTO70
X999. (= none)
N70 X70. (= rapid to X70)
/GOTO80
X71. (= none)
N80 Y[6/2] (= rapid to Y3)
IF[[#1EQ2]AND[#11EQ8]]GOTO#12 (= ! CH202 "N0" "PS0078")
X999. (= none)
M30
%
