%
O2003 (A BORE BY ONE BLOCK)
(machine: mitsubishi-m700)
(P adds full turns: G03 with P9 turns ten times while Z goes 20 deep, a lead of 2.)
G21 G17 G90 G40 G49 G80
T1 M06 (END MILL 16)
G54 G00 X0. Y0. S3000 M03
G43 H01 Z5. M08
G01 Z0. F500.
G01 X12.
G03 I-12. Z-20. P9 F800.
G03 I-12. F600. (THE FLOOR)
G01 X0.
G00 Z50. M09
M05
M30
%
