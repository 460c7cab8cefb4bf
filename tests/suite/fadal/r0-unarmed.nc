(machine: fadal-4020)
(R0 in a move, and no G2 or G3 came before.)
S1000 M3
G90 G0 X0 Y0 Z0
G1 F20.
X1. Y1. R0+1. (= line to X1 Y1 | ! CH405 "I, J, OR K MUST BE SPECIFIED")
X1. Y1. R0+1. G3 (= none | ! CH403)
X3. Y1. R0+.5 (= line to X3 Y1 | ! CH402 "2 in apart" "BAD CIRCLE")
M2
