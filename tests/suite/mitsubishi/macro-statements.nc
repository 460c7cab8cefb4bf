%
O1 (MITSUBISHI: MACROS)
(machine: mitsubishi-m700)
(units: mm)
N1 G21 G90 G17 G94 S1000 M3 F100. G0 X0 Y0
(Without brackets a word is a sum; null counts as zero there.)
X#1+10 (= rapid to X10)
X#1 Y5. (= rapid to X10 Y5)
#900000=4.
X#900000 (= rapid to X4)
#1=SQR[16]
X[RND[1.2]+#1] (= rapid to X5.2)
(Loops take 1 to 127.)
#2=0
WHILE[#2LT2]DO127
#2=#2+1
Y#2 (= rapid to Y1 | rapid to Y2)
END127
G66 P9100 R5.
X20. (= rapid to X20)
G67
X30. (= rapid to X30)
#3=1/#0 (= ! CH707 "P283")
#3=LN[0] (= ! CH708 "P282")
#4600=1 (= ! CH705 "P241")
G65 P9101 A1.
M30
O9100
Z#18 (= rapid to Z5)
M99
O9101
#3000=12(TOO LARGE) (= ! CH716 "12 TOO LARGE")
M99
%
