%
(machine: fanuc-30i)
O1 (MAIN)
(M98 with L, with repeats packed into P, and a return to a block of the caller.)
G21 G17 G90 S1000 M3
G0 X0. Y0. Z0.
G1 F100.
M98 P5 L2
M98 P30005
M98 P6
Y9. (= none)
N20 Y10. (= line to X5 Y10)
M30
O5 (AN INCREMENT)
G91 X1. (= line to X1 | line to X2 | line to X3 | line to X4 | line to X5)
G90
M99
O6 (BACK TO N20)
M99 P20
%
