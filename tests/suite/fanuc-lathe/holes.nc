(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
G21 G18 G40 G80 G99 G97 S800 M3
T0101
G0 X0 Z5.
(R is a distance from where the tool is, and no distance without it; without Q it is one cut.)
G83 Z-10. R-3. F.1 (= rapid to X0 Z2 | line to X0 Z-10 | rapid to X0 Z5)
G83 Z-9. R-4. Q5000 (= rapid to X0 Z1 | line to X0 Z-4 | rapid to X0 Z1 | rapid to X0 Z-3 | line to X0 Z-9 | rapid to X0 Z5)
G83 W-6. R-4. (= rapid to X0 Z1 | line to X0 Z-4 | rapid to X0 Z1 | rapid to X0 Z-3 | line to X0 Z-5 | rapid to X0 Z5)
G85 Z-8. R-3. P200 (= rapid to X0 Z2 | line to X0 Z-8 | dwell .2 | line to X0 Z2 | rapid to X0 Z5)
G80
G84 Z-12. R-3. F1.5 (= rapid to X0 Z2 | line to X0 Z-12 | line to X0 Z2 | rapid to X0 Z5)
(After a cut R is a distance of the hole, and no rounding.)
G1 Z6. F.2
G83 Z-10. R-4. F.1 (= rapid to X0 Z2 | line to X0 Z-10 | rapid to X0 Z6)
G80
G0 Z5.
(Along X: R is on the radius.)
G0 X40. Z-10.
G87 X20. R-4. F.1 (= rapid to X32 Z-10 | line to X20 Z-10 | rapid to X40 Z-10)
G80
(Corners without a comma, and an angle from Z.)
G0 X20. Z2.
G1 Z-20. R2. F.2 (= line to X20 Z-18 | arc cw to X24 Z-20 radius 2.00)
X40. K-3. (= line to X34 Z-20 | line to X40 Z-23)
W-20. (= line to X40 Z-40)
X50. ,A135. (= line to X50 Z-45)
Z-50. ,A180. (= line to X50 Z-50)
(A thread whose lead grows by 0.5 each turn, and one whose lead ends before it.)
G0 X28. Z5.
G34 Z-20. F1. K.5 (= line to X28 Z-20 length 25.00)
G0 Z5.
G34 Z-20. F1. K-.5 (= ! CH303 "after 1 mm")
M30
