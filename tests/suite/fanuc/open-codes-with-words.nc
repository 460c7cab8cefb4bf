(machine: fanuc-30i)
(set: shop_codes.M170 = {})
(An unknown M code with axis words after it and no G code: a macro call, whose words are no move. It is reported once.)
G21 G17 G90 G94 S1000 M3
G0 X0. Y0. Z50.
M165 P9811 Z0 S1. (= none | ! CH312 "M165" "shop_codes.M165")
M165 P9811 Z0 S2. (= none)
(A code of the machine's builder comes after the move of its block, or in the block of a motion code.)
X10. M166 (= rapid to X10 Y0 Z50 | ! CH306 "M166")
G0 X20. M166 (= rapid to X20)
M166 G0 X30. (= rapid to X30)
G1 X40. M167 P5 F100. (= line to X40 | ! CH306 "M167")
(No axis words at all.)
M168 E5. Q1 (= none | ! CH306 "M168")
M169 P1 (= none | ! CH306 "M169")
(The machine file has said that it is no call: the words are a move.)
M170 X50. (= line to X50)
G91 G0 Z1. (= rapid to X50 Z51)
M30
