%
(machine: haas-vf2)
(The same ends and radius with a negative sign: the long way round, 224.98 degrees.)
O60022 (NEGATIVE R) ;
T1 M06 (TOOL 1) ;
G00 G90 G40 G49 G54 ;
G00 G54 X-0.25 Y-0.25 ; (= rapid to X-.25 Y-.25)
S1000 M03 ;
G43 H01 Z0.1 ; (= rapid to Z.1)
M08 ;
G01 Z-0.5 F20. ; (= line to Z-.5 feed 20)
G01 Y1.5 F12. ; (= line to X-.25 Y1.5 feed 12)
G02 X1.884 Y0.616 R-1.25 ; (= arc cw center X1.0000 Y1.500 radius 1.25 sweep 224.98 to X1.884 Y.616)
G00 Z0.1 M09 ; (= rapid to Z.1)
G53 G49 Z0 M05 ;
G53 Y0 ;
M30 ;
%
