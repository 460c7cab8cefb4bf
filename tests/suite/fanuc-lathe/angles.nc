(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(A line by its angle alone ends where it meets the line of the next block.)
G21 G18 G40 G80 G99 G97 S800 M3
T0101
G0 X20. Z0
G1 ,A180. F.2 (= line from X20 Z0 to X20 Z-20)
X40. Z-30. ,A135. (= line from X20 Z-20 to X40 Z-30)
(With a rounding at their corner, and a chamfer at the end of the second.)
G0 X20. Z0
G1 ,A180. ,R5. (= line to X20 Z-17.9289322 | arc cw to X22.9289322 Z-21.4644661 radius 5.00 sweep 45.00)
X40. Z-30. ,A135. ,C1. (= line to X38.5857864 Z-29.2928932 | line to X40 Z-31)
Z-50. (= line to X40 Z-50)
(A line that meets nothing, or whose next block has no angle.)
G1 ,A180. (= none | ! CH312 "does not meet")
X50. Z-60. ,A0
,A135. (= none | ! CH312 "needs G1, X, Z and")
X60. Z-70.
,A90. (= none | ! CH312 "the program ends")
M30
