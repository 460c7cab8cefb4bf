(machine: fanuc-30i)
(Codes before the one that calls act before the call; those after it cannot be arguments.)
O1
G21 G17 G90 G94 G54
G0 X0. Y0.
G55 G65 P2000 X30. (= none)
(S, M and modes as well: the speed turns before the macro moves.)
S1000 M3 G91 G54 G65 P2001 X3. (= spindle cw)
G90 G1 F100. G65 P2001 X40. (= none)
G90 G1 G65 P2001 X42. F100. (= none)
G65 P2001 X50. G91 (= ! CH714)
(A modal call.)
G91 G0 G66 P2002 Z2. (= none)
X5. (= rapid to X55 Y0)
G67
G90 G54 M98 P2003
G0 X5. M98 P2003 (= rapid to X5 Y0)
M30
O2000
G0 X#24 Y#4014 (= rapid to X30 Y55)
G0 Y0. (= rapid to X30 Y0)
M99
O2001
X#24 (= rapid to X33 | line to X40 feed 100 | line to X42 feed 100 | line to X50)
M99
O2002
Z#26 (= rapid to X55 Y0 Z2)
M99
O2003
G90 (= none)
M99
