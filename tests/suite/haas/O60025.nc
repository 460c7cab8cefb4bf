%
(machine: haas-vf2)
(Single-point thread by a line repeat. In increments from Z.1 the depth is -.4156, five turns end)
(at .2250, the lead-out at .2406; G90 is never restored, so Z0.1 lifts by a tenth to .3406.)
O60025 (SINGLE POINT THREAD MILL) ;
T1 M06 ;
G00 G90 G40 G49 G54 ;
G00 G54 X0 Y0 ;
S1000 M03 ;
G43 H01 Z0.1 ;
M08 ;
G91 G01 Z-0.5156 F50. ; (= line to X0 Y0 Z-.4156)
G41 X0.25 Y-0.25 F20. D01 ; (= line to X.25 Y-.25)
G03 X0.25 Y0.25 I0 J0.25 Z0.0156 ; (= helix ccw center X.25 Y0 sweep 90 to X.5 Y0 Z-.4)
I-0.5 J0 Z0.125 L5 ; (= helix ccw center X0 Y0 radius .5 sweep 360 to X.5 Y0 Z-.275 | helix ccw to Z-.15 | helix to Z-.025 | helix to Z.1 | helix to X.5 Y0 Z.225)
X-0.25 Y0.25 I-0.25 J0 Z0.0156 ; (= helix ccw center X.25 Y0 sweep 90 to X.25 Y.25 Z.2406)
G40 G01 X-0.25 Y-0.25 ; (= line to X0 Y0 Z.2406)
G00 Z0.1 M09 ; (= rapid to X0 Y0 Z.3406)
G53 G49 Z0 M05 ;
G53 Y0 ;
M30 ;
%
