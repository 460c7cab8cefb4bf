(machine: fanuc-0i)
(Neither the work offset nor the length is given: a shift moves the coordinates by what it says, and the place stays)
(known.)
G21 G17 G40 G49 G80 G90
T1 M6
G0 G54 X0 Y0 S1000 M3
G43 H1 Z20.
G52 X3. Z5.
G0 X10. (= rapid from X-3 Y0 Z15 to X10 Y0 Z15)
G52 X0 Z0
G0 X10. (= rapid from X13 Y0 Z20 to X10 Y0 Z20)
M30
