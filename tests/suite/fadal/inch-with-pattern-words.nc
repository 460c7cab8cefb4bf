(machine: fadal-4020)
(G70 of a Fadal is inch. The words of a Haas bolt circle in its block have an answer.)
G20 G90 G17 S1000 M3
G0 X0 Y0 Z1.
G70 I2. J15. L12 (= none | ! CH405)
G81 G99 R0+.1 Z-.6 F40. X1. Y1.
G70 I2. J15. L12 (= none | ! CH304 "`I`" | ! CH304 "`J`" | ! CH304 "`L`")
G80
M2
