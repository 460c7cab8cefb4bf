(machine: haas-vf2)
(units: mm)
(G92 gives the present place its number in every system and clears G52 on the axes it names.)
G21 G90 G17 S1000 M3
G10 L2 P1 X-100. Y-100. Z-200.
G54 G00 X0. Y0. Z200.
G52 X10.
X0. (= rapid from X-10 to X0)
G92 X5. (= none)
X0. (= rapid from X5 to X0)
G52 X0.
X1. (= rapid from X0 to X1)
M30
