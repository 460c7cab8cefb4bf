(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(One pass and back, worked by hand: out to the diameter, along, back out, to the start.)
G21 G18 G40 G99 G97 S800 M3
T0101
G0 X66. Z2.
G90 X60. Z-40. F.25 (= rapid to X60 Z2 | line to X60 Z-40 | line to X66 Z-40 | rapid to X66 Z2)
X54. (= rapid to X54 Z2 | line to X54 Z-40 | line to X66 Z-40 | rapid to X66 Z2)
X50. Z-30. (= rapid to X50 Z2 | line to X50 Z-30 | line to X66 Z-30 | rapid to X66 Z2)
(The taper is start minus end, on the radius.)
G90 X60. Z-40. R-5.25 (= rapid to X49.5 Z2 | line to X60 Z-40 | line to X66 Z-40 | rapid to X66 Z2)
(Along X.)
G94 X20. Z-2. F.2 (= rapid to X66 Z-2 | line to X20 Z-2 | line to X20 Z2 | rapid to X66 Z2)
(U and W count from the start of the pass.)
G90 U-16. W-12. (= rapid to X50 Z2 | line to X50 Z-10 | line to X66 Z-10 | rapid to X66 Z2)
(A thread of 3 mm: the exit is 3 mm long, cut off at the diameter of the start.)
G0 X28. Z6.
G92 X23.2 Z-25. F3. (= rapid to X23.2 Z6 | line to X23.2 Z-22 | line to X28 Z-24.4 | rapid to X28 Z-25 | rapid to X28 Z6)
X22.6 (= rapid to X22.6 Z6 | line to X22.6 Z-22 | line to X28 Z-24.7 | rapid to X28 Z-25 | rapid to X28 Z6)
(One pass of a thread: 24 mm in 12 turns.)
G0 X28. Z4.
G32 Z-20. F2. (= line to X28 Z-20 feed 2 length 24.00)
G28 U0 W0
M30
