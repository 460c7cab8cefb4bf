%
(machine: fanuc-30i)
(set: shop_codes.M78.time = "2 s")
(set: shop_codes.M78.label = "clamp")
(set: shop_codes.M79.blocks = "G91 G0 Z1.\nG90")
(set: shop_codes."G65 P9810".blocks = "G1 X#24 Y#25 Z#26 F#9")
(set: shop_codes.O9832 = {})
(set: shop_codes.O9833.time = "1 s")
O1
(M codes that neither control nor machine file has are noted once and move nothing; macros may move.)
G21 G17 G90 S1000 M3
G0 X0. Y0. Z0.
M123 (= none | ! CH306 "M123" "shop_codes.M123")
M123 (= none)
M124 P5. Q2 R1 K7 (= ! CH306 "M124")
M125 P5. Q2 R1 K7 A1. (= none | ! CH312 "M125")
M9999 (= none | ! CH306 "M9999")
G1 X1. F100. M123 (= line to X1)
M78 (= dwell 2)
M79 (= none)
G65 P9810 X5. Y6. F200.
G65 P9832 (= none)
G65 P9833 (= dwell 1)
G65 P9811 Z-5. (= none | ! CH201 "O9811" "shop_codes.O9811")
G65 P9832 L2 (= none)
M98 P9832 (= none)
G90 X10. (= line from X5 Y6 Z1 to X10 feed 200)
G66 P9812 D5. (= none | ! CH201 "O9812")
X11. (= line to X11)
X12. (= line to X12)
G67
M30
%
