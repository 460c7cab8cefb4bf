(machine: mach3-mill)
(Subroutines of the same file after M30; L or Q counts; one may call another above it.)
G21 G90
G0 X0 Y0
M98 P1234 L2
M98 P5 Q3
M98 P77 (= ! CH201 "O77")
M98 (SIDE 2. AGAIN) (= ! CH308 "without a program number")
M98 (part-2.tap) (= ! CH312 "named by its file")
G90 G0 X0 (= rapid to X0)
M30
O5
G91 X1 (= rapid to X1 Y1 Z1 | rapid to X2 Y2 Z2 | rapid to X3 | rapid to X4 | rapid to X5)
M99
O1234
G91 G0 Y1 (= rapid to X0 Y1 Z0 | rapid to X1 Y2 Z1)
M98 P6
M99
O6
Z1 (= rapid to X0 Y1 Z1 | rapid to X1 Y2 Z2)
M98 P5
M99
