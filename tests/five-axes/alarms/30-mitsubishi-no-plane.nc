(G53.1 without a plane on a Mitsubishi.)
(machine: mit)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G53.1 (= ! "M01 0185")
M30
