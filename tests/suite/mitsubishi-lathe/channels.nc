(machine: mitsubishi-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(Channels: $ begins the program of one, ! waits for another. Each file is followed for itself.)
G21 G18 G40 G99
T0101
G97 S800 M3
G0 X50. Z2.
!2L1 (= none | ! CH312 "!2L1 waits for another channel: only this program is followed, not what the other channel cuts meanwhile")
G1 Z-10. F.2 !2L2 (= line to Z-10)
G0 X100.
G0 B-300. (= none | ! CH306 "no B axis")
M30
