(machine: fanuc-30i)
(units: mm)
(Programs by name, as a 30i has them; letters of either size are the same.)
<MAIN_1>
G21 G17 G90 G94 S1000 M3 F100
G0 X0 Y0 Z0
M98 <SUB_A>
M98 <sub_a> L2
G65 <MAC-B.1> X5.
M98 <O123>
M98 <NOT_HERE> (= ! CH201 "no program <NOT_HERE>")
M30
<SUB_A>
G91 G1 X1. (= line to X1 | line to X2 | line to X3)
G90 M99
<MAC-B.1>
G1 X#24 (= line to X5)
M99
O123
G1 X9. (= line to X9)
M99
