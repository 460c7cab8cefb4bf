(A reference return in polar interpolation.)
(machine: ac)
G21 G17 G90 G94 G40 G49 G80
G54
G0 X50. Y0. C0.
G12.1
G28 X0. (= ! "PS0146")
M30
