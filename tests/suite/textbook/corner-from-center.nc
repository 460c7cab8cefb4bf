(machine: textbook-from-center)
(A round corner, the centre given as from-center; corrected: a point behind Y3, a spindle, a feed.)
N001 G80 G90 G00 G98
N100 T01 M06
N101 G00 X-0.25 Y-0.25 S1000 M03 (= rapid to X-.25 Y-.25)
N102 G44 Z-1. H01 (= rapid to Z-1)
N103 G01 Y3. F7.2 (= line to X-.25 Y3 Z-1 feed 7.2)
N104 X2. (= line to X2 Y3)
N105 G17 G02 X3. Y2. I0. J1. F7.2 (= arc cw center X2 Y2 radius 1 sweep 90 to X3 Y2 length 1.570796)
N106 G01 Y-0.25 (= line to X3 Y-.25)
N107 X-0.25 (= line to X-.25)
N108 G00 Z0. M05 (= rapid to Z0)
N109 G49
N110 G91 G28 X0. Y0. Z0.
N111 M30
