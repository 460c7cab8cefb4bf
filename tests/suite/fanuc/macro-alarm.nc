%
O0001 (MACRO B: ALARMS)
(machine: fanuc-30i)
(units: mm)
N1 G21 G90 G17 G94 S1000 M3 F100. G0 X0 Y0
N2 #1=#0
N2 #3=1/0 (= ! CH707 "PS0112")
N3 #1=SQRT[-1] (= ! CH708 "-1" "PS0119")
N4 #1=[[[[[[1]]]]]] (= ! CH702 "PS0118")
N5 #1=[1+2 (= ! CH701 "PS0118")
N6 #34=1 (= ! CH705 "#34" "PS0115")
N7 #5001=1 (= ! CH706 "PS0116")
N8 #1=1 G0 X1. (= rapid to X1 | ! CH715 "PS0127")
N9 #1=2EQ2 (= ! CH710)
N10 IF[1EQ1]THEN G0 X2. (= rapid to X2 | ! CH704 "THEN")
N11 END1 (= ! CH712 "PS0124")
N12 WHILE[1EQ2]DO4 (= ! CH711 "PS0126")
N13 DO01 (= ! CH704 "leading zero")
N14 ##1=2 (= ! CH703 "#[#1]")
N15 #1=FOO[1] (= ! CH703 "not a function")
N16 ENDIF (= ! CH704 "no IF block")
N17 SETVN500[A (= ! CH704)
N18 M[3.5] (= ! CH720 "taken as M4")
N19 #1= (= ! CH700 "a value is missing")
N20 X#1#2 (= rapid to X1 | ! CH704 | ! CH715)
#3000=91(A*INPUT*MISSING) (= ! CH716 "3091 A*INPUT*MISSING")
X999. (= none)
M30
%
