%
O0001 (MACRO B: WORDS WITH EXPRESSIONS)
(machine: fanuc-30i)
(units: inch)
N1 S1000 M3 G20 G90 G17 G40 G49 G80 G94
N2 #1=1.5
N3 #2=#1*2+1 (COMMENT)
N4 G0 X#1 Y-#1 (= rapid to X1.5 Y-1.5)
N5 X[#1+#2] Y-[#2-1.] (= rapid to X5.5 Y-3)
N6 G[1] F[#1*10] X#1 Y[-#1] (= line to X1.5 Y-1.5 feed 15)
N7 #10=1.23456
N8 X#10 Y#30 (= line to X1.2346 Y-1.5)
N9 X[2*SIN[30]] Y[ATAN[1]/[-1]/100] (= line to X1 Y1.35)
N10 X [ # 1 + # [ 1 ] ] (= line to X3)
N11 #101=2 ; #[100+1]=#101+.5 ; X#101 (= line to X2.5)
M30
%
