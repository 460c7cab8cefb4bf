%
O0001 (MACRO B: NULL)
(machine: fanuc-30i)
(units: mm)
N1 G21 G90 G17 G94 S1000 M3 F100.
N2 POPEN
(In arithmetic null is zero and the result a number; assigned, it stays null.)
N3 #1=#0
N4 #2=#0*10
N5 #3=#0+#0
N6 IF[#1EQ#0]GOTO8
N7 X999. (= none)
N8 IF[#2EQ#0]GOTO10
N9 G0 X1. (= rapid to X1)
N10 IF[#3NE#0]GOTO12
N11 X999. (= none)
(EQ and NE: null is not zero. GE, LE, GT, LT: null acts as zero.)
N12 IF[#1EQ0]GOTO99
N13 IF[#1NE0]GOTO15
N14 X999. (= none)
N15 IF[#1GE0]GOTO17
N16 X999. (= none)
N17 IF[#1GT0]GOTO99
N18 IF[#1LE0]GOTO20
N19 X999. (= none)
N20 X2. (= rapid to X2)
(A null word is dropped, address and all.)
N21 X20. Y#1 (= rapid to X20 Y0)
N22 X#1 Y#0 (= none)
N23 X[#1] Y5. (= rapid to X20 Y5)
N24 X[#1+3.] (= rapid to X3 Y5)
N25 X-#1 Y6. (= rapid to X0 Y6)
N26 DPRNT[A#1[31]*B#2[10]] (= > "A   0.0 B 0")
N27 #0=5 (= ! CH706 "PS0116")
N28 PCLOS
M30
N99 X999. (= none)
M30
%
