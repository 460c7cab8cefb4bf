(A rapid in cylindrical interpolation.)
(machine: ac)
G21 G17 G90 G94 G40 G49 G80
G54
G18
G7.1 C50.
G0 Z10. C20. (= ! "PS0176")
M30
