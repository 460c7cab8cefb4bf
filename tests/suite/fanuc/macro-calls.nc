%
O0001 (MACRO B: CALLS)
(machine: fanuc-30i)
(units: mm)
(set: settings.No. 6050 = 123)
(set: settings.No. 6071 = 71)
N1 G21 G90 G17 G94 S1000 M3 F100. G0 X0 Y0
N2 #1=77.
(Type I and II mixed: the later word wins. #4=-3, #7=5.)
N3 G65 P9100 A1. B2. I-3. I4. D5.
N4 X#1 (= rapid to X77)
(Without a point a length counts thousandths, D and F whole.)
N5 G65 P9110 X1500 D2 F30
(L repeats the macro with the variables it left.)
N6 G65 P9120 L3 A1.
(Null arguments stay null.)
N7 G65 P9130 A#0 B1.
(M98 shares the local variables.)
N8 M98 P9140
N9 X#2 (= rapid to X5)
(G66: after every block that moves, not in its own.)
N10 G66 P9150 Z-2.
N11 X10. (= rapid to X10)
N12 X20. Y1. (= rapid to X20 Y1)
N13 M8 (= none)
N14 G67
N15 X30. (= rapid to X30)
(G123 calls O9010 by No. 6050, M71 calls O9001 by No. 6071.)
N16 G123 X40. (= none)
N17 M71
N18 G65 P9100 G1 A1. B2. I-3. D5. (= ! CH714 "PS0129")
N19 G65 P9999 (= ! CH201 "O9999")
N20 G65 P9160 A1.
M30
O9100
X#1 Y#2 (= rapid to X1 Y2 | rapid to X1 Y2)
X#4 Y#7 (= rapid to X-3 Y5 | rapid to X-3 Y5)
M99
O9110
X#24 Y#7 (= rapid to X1.5 Y2)
M99
O9120
X#1 (= rapid to X1 | rapid to X2 | rapid to X4)
#1=#1*2
M99
O9130
IF[#1NE#0]GOTO1
X#2 (= rapid to X1)
N1 M99
O9140
#2=5.
M99
O9150
Z#26 (= rapid to Z-2 | rapid to Z-2)
Z0 (= rapid to Z0 | rapid to Z0)
M99
O9010
X#24 (= rapid to X40)
M99
O9001
X71. (= rapid to X71)
M99
O9160
G65 P9160 A#1 (= ! CH713 "5 levels deep" "PS0122")
M99
%
