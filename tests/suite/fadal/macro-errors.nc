(machine: fadal-4020)
(What the control refuses, with its words.)
G90 G0 X0 Y0 Z0
#V1=1/0 ' (= ! CH707 "ATTEMPTED DIVISION BY ZERO")
#V1=SQR(-4) ' (= ! CH708 "ATTEMPTED SQR OF A NEGATIVE NUMBER")
#V101=1 ' (= ! CH705 "1 to 100" "NUMBER OUT OF RANGE")
#V1=.00001 ' (= ! CH740 "nearer to zero")
#V1=999999*9999999 ' (= ! CH740 "too large")
G1 #V1=2 ' (= ! CH715 "ONLY BLOCK SKIP ALLOWED WITH MACRO")
/#V2=3
#V3=HELLO(1) ' (= ! CH703 "UNDEFINED MACRO ERROR")
#LET V3=1 ' (= ! CH704 "UNDEFINED MACRO ERROR")
#V3=(1+2 ' (= ! CH701)
#IF V1=2 GOTO 5 ' (= ! CH704 "THEN")
#AX=1 ' (= ! CH706)
#V1=1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1 ' (= ! CH741 "63")
#R1=V2
G0 X+R1 (= rapid to X3)
#GOTO :NOWHERE ' (= ! CH202 "NOWHERE")
X5. (= none)
M2
