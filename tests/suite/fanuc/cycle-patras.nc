(machine: fanuc-30i)
(units: inch)
(Holes of the lecture's part: the initial level is below Z0.)
G20 G17 G90 G94 F10.
S1000 M3
G0 X0. Y0. Z-.525
G81 G98 X1.132 Y.654 Z-2.125 R-1.525 (= rapid to X1.132 Y.654 Z-.525 | rapid to Z-1.525 | line to Z-2.125 | rapid to Z-.525)
X-1.132 (= rapid to X-1.132 Z-.525 | rapid to Z-1.525 | line to Z-2.125 | rapid to Z-.525)
X0. Y-1.308 (= rapid to X0 Y-1.308 | rapid to Z-1.525 | line to Z-2.125 | rapid to Z-.525)
G85 Z-2.075 (= rapid to Z-1.525 | line to Z-2.075 | line to Z-1.525 | rapid to Z-.525)
G80
M30
