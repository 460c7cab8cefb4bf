(C must turn through half a turn in a tenth of a second.)
(machine: ac)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G0 A20. C0.
G43.4 H2 X10. Y0. Z50.
G1 X10. F15000.
X12. C180. (= ! "PS5422")
M30
