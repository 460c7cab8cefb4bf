%
(machine: fanuc-30i)
(units: mm)
(same motion on: haas-vf2 mitsubishi-m700 linuxcnc-mill fadal-4020)
(A program that all five controls run alike: points everywhere, G codes everywhere.)
O1
G21 G17 G90 G94
S1000 M3
G0 X0. Y0. Z5.
G1 Z-1. F200.
G2 X10. Y10. I10. J0. (= arc cw center X10 Y0 radius 10 sweep 90)
G3 X20. Y20. I0. J10. (= arc ccw center X10 Y20 sweep 90)
G1 X30.
G18 G3 X40. Z9. I10. K0. (= arc ccw plane zx center Z-1 X40 radius 10 sweep 90)
G17 G2 I-5. J0. (= arc cw sweep 360)
G1 X0. Y0. F100.
M5
M30
%
