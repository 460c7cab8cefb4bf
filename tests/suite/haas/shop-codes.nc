(Codes that the shop's machine has and the control does not, by its machine file.)
(machine: haas-vf2)
(set: shop_codes.M120.time = "2.5 s")
(set: shop_codes.M120.label = "part flip")
(set: shop_codes.M39.time = "0.5 s")
(set: shop_codes.M121 = {})
G20 G90 G54 S1000 M3
G0 X10. Y0. Z5. (= rapid to X10 Y0 Z5)
(A wait comes after the move of its block; words that nothing else takes are the shop's.)
M120 P2 X20. (= rapid to X20 Y0 Z5 | dwell 2.5)
(Two codes in one block, in their order, beside one of the control's.)
M120 M8 M39 (= dwell 2.5 | dwell .5)
(The control has M39, and Chordal does not carry it out; without a time it is known all the same.)
M39 (= dwell .5)
M121 L4
M122 (= ! CH301 "has no M122")
M30
