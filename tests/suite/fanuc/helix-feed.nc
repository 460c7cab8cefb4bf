(machine: fanuc-30i)
(set: settings."No. 1403#5" = 1)
(With HTG set, F counts along the helix.)
G21 G17 G90 S1000 M3
G0 X0. Y0. Z0.
G1 F100.
G2 I5. Z-1. (= helix cw sweep 360 along path feed 100)
M30
