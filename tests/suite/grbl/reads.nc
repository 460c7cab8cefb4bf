(machine: grbl)
(Blanks and slashes are dropped, codes count in hundredths, numbers have eight digits.)
G21 G90
/G0 X5 (= rapid to X5)
g 0 x 1 2 . 5 (= rapid to X12.5)
G0.004 X0.12345678 (= rapid to X0.1234567)
G00 X000000001 (= rapid to X0)
G4 P0.5 X3 (= dwell 0.5 | rapid to X3)
G43.1 Z2
G0 Z1 (= rapid to Z1)
G49 X5 (= ! CH304 "no effect")
G10 L2 P1 X1
G0 X0 (= rapid to X0)
G10 L20 P1 X7
G0 X7
G92 X2
G0 X0 (= rapid to X0)
G92.1
G55
G54
