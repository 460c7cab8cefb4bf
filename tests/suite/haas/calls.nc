%
O1000 (LOCAL CALLS, PROGRAMS, REPEATS)
(machine: haas-vf2)
(units: mm)
G21 G90 G17 S1000 M3
G00 X0. Y0. Z0.
G01 F100.
M97 P10 L3
M98 P7 L2
G01 X0. Y0. (= line to X0 Y0)
M30
N10 G91 G01 X1. (= line to X1 | line to X2 | line to X3)
G90
M99
O0007 (CALLED)
G91 G01 Y2. (= line to X3 Y2 | line to X3 Y4)
G90
M99
%
