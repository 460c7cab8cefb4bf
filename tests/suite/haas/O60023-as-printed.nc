%
(machine: haas-vf2)
(Inside thread. As printed the lead-out ends at Y1, without a point: .0001 in on this control,)
(and with a point it would leave the bore. Y0 is meant.)
O60023 (THREAD MILL 1.5-8) ;
T1 M06 ;
G00 G90 G40 G49 G54 ;
G00 G54 X0 Y0 ;
S1000 M03 ;
G43 H01 Z0.1 ;
M08 ;
G01 Z-0.5156 F50. ; (= line to X0 Y0 Z-.5156)
G41 X0.25 Y-0.25 F10. D01 ; (= line to X.25 Y-.25)
G03 X0.5 Y0 I0 J0.25 Z-0.5 ; (= helix ccw center X.25 Y0 radius .25 sweep 90 to X.5 Y0 Z-.5)
I-0.5 J0 Z-0.375 F20. ; (= helix ccw center X0 Y0 radius .5 sweep 360 to X.5 Y0 Z-.375 tangent .01)
X0.25 Y0.25 I-0.25 J0 Z-0.3594 ; (= helix ccw center X.25 Y0 radius .25 sweep 90 to X.25 Y.25 Z-.3594 tangent .01)
G40 G01 X0 Y1 ; (= line to X0 Y.0001 | ! CH305 "0.0001 in")
G00 Z0.1 M09 ;
G53 G49 Z0 M05 ;
G53 Y0 ;
M30 ;
%
