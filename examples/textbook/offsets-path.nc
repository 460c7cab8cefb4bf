(machine: fanuc-6m)
(A chamfered block beside which a .5 end mill runs, its centre worked out by hand: .25 tan 30 above)
(the edge, .25 tan 15 before the corner.)
N10 G80 G90 G00 G20 G17 G40 G49
N20 T01 M06
N30 G00 X-0.25 Y-0.5 S1200 M03
N40 G43 Z0.1 H01 M08
N50 G01 Z-0.25 F5.
N60 G01 Y1.144 F10.
N70 X1.665 Y2.25
N80 X4.25
N90 G00 Z0.1 M09
N100 G49 M05
N110 G91 G28 Z0.
N120 M30
