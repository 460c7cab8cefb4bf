(A third rotation in space.)
(machine: ac)
G21 G17 G90 G94 G40 G49 G80
G54
G68 X0. Y0. Z0. I0. J0. K1. R10.
G68 X0. Y0. Z0. I1. J0. K0. R10.
G68 X0. Y0. Z0. I0. J1. K0. R10. (= ! "PS5043")
M30
