(machine: haas-vf2)
(units: mm)
(Feeds that nobody means: an inch feed in millimetres, and a cut of hours.)
G21 G90 G17 S900 M3
G0 X0 Y0 Z2.
G1 Z-1. F1. (= line to X0 Y0 Z-1.)
X50. (= line to X50. | ! CH607 "50 minutes" "50 mm at 1 mm a minute")
F19.
X0 (= line to X0)
G2 X0 Y0 I60. F2. (= arc cw | ! CH607 "3 h 8 min" "376.991 mm at 2 mm a minute")
(a slow plunge and a slow but usual feed are not reported)
G1 Z-3. F.5 (= line to Z-3.)
G1 X200. F21. (= line to X200.)
G93 G1 X0 F.05 (= line to X0)
G94 F100.
G0 Z50.
M30
