(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(The same on a lathe, where U and W are axis words.)
G21 G18 G40 G99
T0101
G97 S800 M3
G0 X50. Z2.
M265 W-5. Q3 (= none | ! CH312 "M265" "shop_codes.M265")
U5. M266 (= rapid to X55 Z2 | ! CH306 "M266")
G0 Z5. M267 (= rapid to Z5 | ! CH306 "M267")
M30
