(machine: fanuc-lathe)
(set: tools.1.insert=CNMG120408)
(set: tools.1.holder_designation=PCLNR 2525M12)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(show: path)
(The insert has a nose of 0.8 mm, and a right-hand holder the tip 3: 0.6111 is r times 1 - tan a/2 of a slope of 1 in 2.)
(T1 ROUGH CNMG120404) (= ! CH671 "nose radius of 0.4 mm" "the machine file 0.8 mm")
(T2 INSERT: DNMG150608, NOSE RADIUS: 0.4) (= ! CH671 "nose radius of 0.4 mm" "its insert has 0.8 mm")
(T3 FINISH DNMG150604, NOSE RADIUS: 0.4)
G21 G18 G40 G99 G97 S800 M3
T0101
G0 X30. Z5.
G42 G1 X20. Z2. F.2 (= line to X20 Z1.2)
Z-20. (= line to X20 Z-20.611146)
X40. Z-40. (= line to X40 Z-40.611146)
Z-60. (= line to X40 Z-60.8)
G40 X50. (= line to X50 Z-60)
M30
