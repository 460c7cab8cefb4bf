(machine: grblhal)
(set: settings.expressions = on)
(A comment goes, and the words around it act, wherever it stands.)
G21 G90 G17
M3 S1000 F100
(cut 1) G1 X5 (= line to X5)
(cut 2)G1 X6(twice) Y1 (= line to X6 Y1)
N10 (cut 3) X7 (= line to X7)
(cut 4) N20 X8 (= line to X8)
/(cut 5) X9 (= line to X9)
X(between)10 (= line to X10)
  (blanks before) X11 ; and a remark (= line to X11)
(nothing but this)
(cut 6) #1=4
(cut 7) X#1 (= line to X4)
M30
