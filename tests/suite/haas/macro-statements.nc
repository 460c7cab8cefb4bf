%
O00001 (HAAS MACROS: STATEMENTS)
(machine: haas-vf2)
(set: macros.variables.10500 = 2.5)
(set: macros.variables.550 = 3)
(set: macros.date = 2024-05-17)
N1 G20 G90 G17 G94 G40 G80 S1000 M3 F10. G0 X0 Y0
(#500 is another name of #10500; the machine file gives its value.)
X#500 (= rapid to X2.5)
#501=#500+1. (AND BACK)
X#10501 Y#550 (= rapid to X3.5 Y3)
(A comparison is a value.)
#1=[#500EQ2.5]
#2=[#500LT0]
X#1 Y#2 (= rapid to X1 Y0)
IF[#1]THEN X4. (= rapid to X4)
IF[#2]THEN X999. (= none)
IF[#3]THEN X999. (= none)
IF[#3NE#0]THEN X999. (= none)
(Anything but GOTO behind THEN; a condition alone holds for its line.)
IF[#1EQ1]THEN G01 X5. F20. (= line to X5 feed 20)
IF [ #10501 EQ 3.5 ] THEN #3=6. G0 X#3 (= rapid to X6)
[#1EQ1] X7. (= rapid to X7)
[#1EQ0] X999. (= none)
(GOTO shares a block and acts last; its number is rounded.)
X8. GOTO4.5 (= rapid to X8)
X999. (= none)
N5 X9. (= rapid to X9)
GOTO#4
X999. (= none)
N0 X10. (= rapid to X10)
(A word is rounded to its increment; ROUND inside a word too.)
#1=1.00333
X[#1+#1] (= rapid to X2.0067)
X[ROUND[#1]+ROUND[#1]] (= rapid to X2.0066)
Y[ROUND[1.6]] (= rapid to Y1.6)
#2=ROUND[1.6]
Y#2 (= rapid to Y2)
(G codes and M codes by value.)
#5=91
G#5 X1. (= rapid to X3.0066)
G[#5-1] X3. (= rapid to X3)
(Date of the machine file.)
DPRNT[DATE*#3011[80]] (= > "DATE 20240517")
#1=123.456789
DPRNT[X-#1[35]*Y#500[12]*T#500[20]] (= > "X-123.45679 Y2.50 T3")
DPRNT[X#1] (= > "X123.4568" | ! CH718)
(Stop with a message.)
#3006=1(TURN THE PART) (= ! CH722 "TURN THE PART")
(What a Haas does not have.)
#1=FUP[1.5] (= ! CH703)
G65 P9001 X1 D2 A3
G65 P9002 I1. J2. I3.
IF[#0EQ0]THEN X999. (= none)
/ #3000=1(DELETED BY THE SWITCH)
(block-delete: on)
WHILE[#9LT2]DO1
#9=#9+1
X#9 (= rapid to X1 | rapid to X2)
END1
M30
O09001
X#24 Y#7 Z#1 (= rapid to X.0001 Y2 Z.0003)
M99
O09002
X#4 Y#5 Z#7 (= rapid to X1 Y2 Z3)
M99
%
