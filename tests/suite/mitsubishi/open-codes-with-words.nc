(machine: mitsubishi-m700)
G21 G17 G90 G94 S1000 M3
G0 X0. Y0. Z50.
M165 P9811 Z0 S1. (= none | ! CH312 "M165" "shop_codes.M165")
X10. M166 (= rapid to X10 Y0 Z50 | ! CH306 "M166")
M30
