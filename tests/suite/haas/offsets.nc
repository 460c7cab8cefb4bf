(machine: haas-vf2)
(units: mm)
(Work offsets, worked out in machine coordinates: G54 at -100 -100 -200, G154 P3 at -50.)
G21 G90 G17 S1000 M3
G10 L2 P1 X-100. Y-100. Z-200.
G10 L20 P3 X-50. Y-100. Z-200.
G54 G00 X0. Y0. Z200. (= rapid to X0 Y0 Z200)
G52 X10. (= none)
G00 X0. (= rapid from X-10 to X0)
G154 P3 X0. (= rapid from X-50 to X0)
G52 X0.
X0. (= rapid from X10 to X0)
G53 X-20. (= rapid from X0 to X30)
G54 X0. (= rapid from X80 to X0)
G112 X1. (= rapid from X-50 to X1)
G28 (= rapid to X50 Y100 Z200)
M30
