(machine: grblhal)
(Holes: pecks dwell a quarter of a second, return to the level of G98 or G99 and feed down from there.)
G21 G90 G17 G94
G0 Z10
G98 G81 X10 Y5 Z-3 R2 F120 (= rapid to X10 Y5 | rapid to Z2 | line to Z-3 feed 120 | rapid to Z10)
G99 X20 (= rapid to X20 | rapid to Z2 | line to Z-3 | rapid to Z2)
G83 X30 Z-5 Q3 (= rapid to X30 | line to Z-1 | dwell 0.25 | rapid to Z2 | line to Z-4 | dwell 0.25 | rapid to Z2 | line to Z-5 | dwell 0.25 | rapid to Z2)
G80
G0 Z10
G98 G83 X40 Z-4 R2 Q3 (= rapid to X40 | rapid to Z2 | line to Z-1 | dwell 0.25 | rapid to Z10 | line to Z-4 | dwell 0.25 | rapid to Z10)
G73 X50 Z-4 R2 Q3 (= rapid to X50 | rapid to Z2 | line to Z-1 | dwell 0.25 | rapid to Z-0.9 | line to Z-4 | dwell 0.25 | rapid to Z10)
G82 X60 Z-1 R1 P0.5 (= rapid to X60 | rapid to Z1 | line to Z-1 | dwell 0.5 | rapid to Z10)
G85 X70 (= rapid to X70 | rapid to Z1 | line to Z-1 | line to Z1 | rapid to Z10)
G80
G91 G81 X-10 Y0 Z-2 R-9 L2 (= rapid to X60 | rapid to Z1 | line to Z-1 | rapid to Z10 | rapid to X50 | rapid to Z1 | line to Z-1 | rapid to Z10)
G90 G80
M30
