(machine: fanuc-lathe-c)
(set: settings."No. 8110"=100)
(set: settings."No. 8111"=199)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
G21 G18 G40 G98
T0101
S800 M3 P13 (= spindle cw | ! CH306 "P13 names the second spindle")
M5
(A live tool by P, at its own speed.)
S1500 P12 M3 (= spindle cw)
G0 X50. Z2. C0
M100 P12 (= none | ! CH312 "M100 waits for another channel: only this program is followed")
G1 Z-10. F100. (= line to Z-10 feed 100)
M101 P12 (= none)
M5 P12 (= spindle off)
(M200 is the builder's.)
M200 (= none | ! CH306)
M30
