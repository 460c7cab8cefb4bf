(A length in cylindrical interpolation.)
(machine: mit)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G18
G7.1 C50.
G43 H2 (= ! "P481")
M30
