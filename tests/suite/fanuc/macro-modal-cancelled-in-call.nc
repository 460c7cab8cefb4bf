%
O0001 (MACRO B: A MODAL CALL THAT A CALLED PROGRAM CANCELS)
(machine: fanuc-30i)
(units: mm)
(What M98 calls belongs to the same macro level: its G67 ends the call for what follows, too.)
N1 G21 G90 G17 G94 S1000 M3 F100. G0 X0 Y0
N2 G66 P9201 Z-1.
N3 X10. (= rapid to X10)
N4 M98 P9202
N5 X20. (= rapid to X20)
N6 X30. (= rapid to X30)
M30
O9201
G4 P100 (= dwell .1)
M99
O9202
G67
M99
%
