(machine: fadal-4020)
(What subroutines may not do: a line repeat inside one, a subroutine that is not there, a head)
(after the section, a return of nothing.)
L100
G91 X1. L2 (= rapid to X1 | rapid to X2 | ! CH206 "only in the main program")
M17
M30
S1000 M3
G90 G0 X0 Y0 Z0
L102
L301 (= none | ! CH201 "L300")
L200 (= none | ! CH210)
M17 (= none | ! CH208)
M98 P9 (= none | ! CH201 "O9")
M2
