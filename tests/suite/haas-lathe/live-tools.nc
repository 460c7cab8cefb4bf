(machine: haas-lathe-y)
(set: settings.units="mm")
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(The spindle turns, and stops where it becomes the C axis. A live tool has codes of its own with P as its speed.)
G21 G18 G40 G80 G99
T101
G97 S1200 M3 (= spindle cw)
G0 X60. Z5.
G1 Z2. F.1 (= line to Z2 feed .1)
M154 (= spindle off)
G0 C0
G1 Z1. F.1 (= line to Z1 | ! CH413)
M133 P2000 (= spindle cw)
G98
G1 Z0 F200. (= line to Z0 feed 200)
(S and M5 are for the spindle: the live tool goes on.)
S900 M5 (= none)
G1 Z-1. (= line to Z-1 feed 200)
M134 (= spindle ccw)
M135 (= spindle off)
M133 S1500 (= spindle cw)
M133 P9000 (= spindle cw | ! CH606 "P9000 is above the 6000 rpm of live tools")
M135
(M3: the spindle cuts again, at its own speed.)
M133 P1000
S700 M3 (= spindle cw)
M135 (= none)
M5 (= spindle off)
(Taps in a live tool: along Z with R as a level, along X from where the tool is. F is the lead in G99.)
M154
G99 S500
G0 X40. Z3. C0
G95 Z-10. R2. F1. (= rapid to X40 Z2 | spindle cw | line to X40 Z-10 | spindle off | spindle ccw | line to X40 Z2 | spindle off | rapid to X40 Z3)
C90. (= rapid to X40 C90 Z3 | rapid to X40 C90 Z2 | line to X40 C90 Z-10 | line to X40 C90 Z2 | rapid to X40 C90 Z3)
G80
G186 Z-8. R2. F1. (= rapid to X40 Z2 | line to X40 Z-8 | line to X40 Z2 | rapid to X40 Z3)
G80
G0 X44. Z-12.
G195 X30. F1. (= line to X30 Z-12 | line to X44 Z-12)
G80
G196 X32. F1. (= line to X32 Z-12 | line to X44 Z-12)
G80
(Along X R is a diameter.)
G98 M133 P3000
G246 X20. R42. F150. (= rapid to X42 Z-12 | line to X20 Z-12 | spindle off | rapid to X44 Z-12 | spindle cw)
G80
M135
M155
M133
M30
