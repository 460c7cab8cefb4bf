%
O0001 (MACRO B: FUNCTIONS, THEIR VALUES PRINTED)
(machine: fanuc-30i)
(units: mm)
G21 G90
POPEN
#1=SIN[30] (degrees)
#2=ATAN[-1]/[-1]
#3=ATAN[1]/[-1]
#4=ASIN[-.5]
DPRNT[#1[13]#2[33]#3[33]#4[33]] (= > " 0.500 225.000 135.000 330.000")
#1=ACOS[-1]
#2=TAN[45]
#3=SQRT[2]
#4=ABS[-3]
DPRNT[#1[33]#2[13]#3[13]#4[10]] (= > " 180.000 1.000 1.414 3")
#1=FIX[-1.5]
#2=FUP[-1.5]
#3=ROUND[-1.5]
#4=ROUND[2.5]
DPRNT[#1[10]#2[10]#3[10]#4[10]] (= > "-1-2-2 3")
#1=27MOD20
#2=-27MOD20
#3=LN[EXP[2]]
#4=BIN[22]
DPRNT[#1[10]#2[10]#3[10]#4[20]] (= > " 7-7 2 16")
#120=6
#1=0
IF[#120AND4EQ4]THEN #1=1
#2=12XOR10
#3=12OR3
#4=BCD[34]
DPRNT[#1[10]#2[10]#3[20]#4[20]] (= > " 1 6 15 52")
(Precedence, and a minus anywhere.)
#1=2+3*4-10/5
#2=-[2+3]*-2
#3=2*3MOD4
#4=RO[2.4]+FI[2.9]+FU[2.1]
DPRNT[#1[20]#2[20]#3[10]#4[10]] (= > " 12 10 2 7")
DPRNT[] (= > "")
DPRNT[X-#1[20]*END/1] (= > "X- 12 END/1")
PCLOS
M30
%
