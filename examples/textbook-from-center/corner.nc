(machine: textbook-from-center)
(The same corner with the way from the centre to the start: J1. points up to the cutter.)
N001 G80 G90 G00 G98
N100 T01 M06
N101 G00 X-0.25 Y-0.25 S1000 M03
N102 G44 Z-1. H01
N103 G01 Y3. F7.2
N104 X2.
N105 G17 G02 X3. Y2. I0. J1.
N106 G01 Y-0.25
N107 X-0.25
N108 G00 Z0.
N109 G49 M05
N110 G91 G28 X0. Y0. Z0.
N111 M30
