(A local system in a conversion in space.)
(machine: mit)
G21 G17 G90 G94 G40 G49 G80
G54
G68.1 X0. Y0. Z0. I0. J0. K1. R10.
G52 X10. (= ! "P921")
M30
