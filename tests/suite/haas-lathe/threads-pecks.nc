(machine: haas-lathe)
(set: settings.units="mm")
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(set: settings."Setting 22"="0.5 mm")
G21 G18 G40 G99
T101
G97 S800 M03
G0 X28. Z4.
(K is the height and D the first pass: with D a half of K there are 4 passes of the same area. Without A the infeed is straight.)
G76 X21. Z-20. K2. D1. F1. (= rapid to X23 Z4 | line to X23 Z-19 | line to X25 Z-20 | rapid to X28 Z-20 | rapid to X28 Z4 | rapid to X22.171573 Z4 | line to X22.171573 Z-19 | line to X24.171573 Z-20 | rapid to X28 Z-20 | rapid to X28 Z4 | rapid to X21.535898 Z4 | line to X21.535898 Z-19 | line to X23.535898 Z-20 | rapid to X28 Z-20 | rapid to X28 Z4 | rapid to X21 Z4 | line to X21 Z-19 | line to X23 Z-20 | rapid to X28 Z-20 | rapid to X28 Z4 | ! CH617 "K of this thread is 2 mm, 2 times its lead of 1 mm")
(M24: no exit at 45 degrees.)
M24
G76 X24. Z-20. K1. D1. F1. (= rapid to X24 Z4 | line to X24 Z-20 | rapid to X28 Z-20 | rapid to X28 Z4)
M23
(Pecks along Z by K, along X by I; D is how far the tool goes aside.)
G0 X0 Z3.
G74 Z-40. K12. F.15 (= line to X0 Z-9 | rapid to X0 Z-8.5 | line to X0 Z-21 | rapid to X0 Z-20.5 | line to X0 Z-33 | rapid to X0 Z-32.5 | line to X0 Z-40 | rapid to X0 Z3)
G0 X62. Z-23.
G75 X50. Z-25.5 I3. K2.5 F.1 (= line to X56 Z-23 | rapid to X57 Z-23 | line to X50 Z-23 | rapid to X62 Z-23 | rapid to X62 Z-25.5 | line to X56 Z-25.5 | rapid to X57 Z-25.5 | line to X50 Z-25.5 | rapid to X62 Z-25.5 | rapid to X62 Z-23)
(One pass and back, straight and tapered.)
G0 X66. Z2.
G90 X60. Z-40. I-5.25 F.25 (= rapid to X49.5 Z2 | line to X60 Z-40 | line to X66 Z-40 | rapid to X66 Z2)
G94 X20. Z-2. F.2 (= rapid to X66 Z-2 | line to X20 Z-2 | line to X20 Z2 | rapid to X66 Z2)
G0 X28. Z6.
G92 X23.2 Z-25. F3. (= rapid to X23.2 Z6 | line to X23.2 Z-22 | line to X28 Z-24.4 | rapid to X28 Z-25 | rapid to X28 Z6)
G32 Z-20. F2. (= line to X28 Z-20)
M30
