(machine: mitsubishi-m700)
(set: work_offsets.G54.X="-100 mm")
(set: work_offsets."G54.1 P3".X="-300 mm")
(set: work_offsets."G54.1 P48".X="-480 mm")
(G54 with P is an extended work offset, as G54.1 with P: #5221 is G54, #4014 what is active.)
O1
G21 G17 G90 G94 S1000 M3
G0 X50.
G53 X0. (= rapid)
G54 P3 (= none)
G53 X0. (= rapid to X300)
G90 G54 P48 G0 X5. (= rapid to X5)
G53 X0. (= rapid to X480)
G54.1 P3
G53 X0. (= rapid to X300)
(P of another code is no number of an offset.)
G54 M98 P2000
G54 G4 P500 (= dwell .5)
G53 X0. (= rapid to X100)
G54 P0 (= ! CH303 "no extended work offset P0")
M30
O2000
G53 X0. (= rapid to X100)
M99
