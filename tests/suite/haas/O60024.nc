%
(machine: haas-vf2)
(Outside thread. The lead arcs start at Y1.4; a tangent entry would need 1.462, so they turn)
(83.32 degrees about -.0039, 1.4620, with a kink of 0.44 degrees at either end of the turn.)
O60024 (THREAD MILL 2.0-16) ;
T1 M06 ;
G00 G90 G40 G49 G54 ;
G00 G54 X0 Y2.4 ;
S1000 M03 ;
G43 H01 Z0.1 ;
M08 ;
G00 Z-1. ; (= rapid to X0 Y2.4 Z-1)
G01 G41 D01 X-0.5 Y1.4 F20. ; (= line to X-.5 Y1.4)
G03 X0 Y0.962 R0.5 F25. ; (= arc ccw center X-.0039 Y1.4620 radius .5 sweep 83.32 to X0 Y.962)
G02 J-0.962 Z-1.0625 ; (= helix cw center X0 Y0 radius .962 sweep 360 to X0 Y.962 Z-1.0625 | ! CH414 "0.44")
G03 X0.5 Y1.4 R0.5 ; (= arc ccw center X.0039 Y1.4620 radius .5 sweep 83.32 to X.5 Y1.4 | ! CH414 "0.44")
G01 G40 X0 Y2.4 F20. ; (= line to X0 Y2.4)
G00 Z0.1 M09 ;
G53 G49 Z0 M05 ;
G53 Y0 ;
M30 ;
%
