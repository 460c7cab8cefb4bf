(machine: haas-lathe)
(set: settings.units="mm")
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(set: tools.2.offset.X="-90 mm")
(set: tools.2.offset.Z="-40 mm")
(set: work_offsets.G54.X="0 mm")
(set: work_offsets.G54.Z="-200 mm")
G21 G18 G40 G80 G99
G50 S3000
G54
T101
G97 S1000 M03
G0 X0 Z5. (= rapid to X0 Z5)
(R is a level, and the tool comes back to where it was.)
G81 Z-10. R2. F.1 (= rapid to X0 Z2 | line to X0 Z-10 | rapid to X0 Z5)
G82 Z-6. R2. P500 (= rapid to X0 Z2 | line to X0 Z-6 | dwell .5 | rapid to X0 Z5)
G83 Z-9. R1. Q5. (= rapid to X0 Z1 | line to X0 Z-4 | rapid to X0 Z1 | rapid to X0 Z-3.492 | line to X0 Z-9 | rapid to X0 Z5)
G85 Z-8. R2. (= rapid to X0 Z2 | line to X0 Z-8 | line to X0 Z2 | rapid to X0 Z5)
G80
(Along X.)
G0 X40. Z-10.
G241 X20. R32. F.1 (= rapid to X32 Z-10 | line to X20 Z-10 | rapid to X40 Z-10)
G80
G0 X40. Z5.
(Offsets: geometry by L10, wear by L11; the other tool's acts at once.)
G10 L11 P2 X.2
T202
G0 X30. (= rapid from X29.8 Z-5 to X30 Z-5)
(What is not followed says so.)
G112 (= none | ! CH443 "has no C axis")
G113
M30
