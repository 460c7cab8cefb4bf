(machine: mach3-mill)
(Two finger holes and three rows of dowel holes in a drawer front. Written for Mach3.)
G70 G90 G91.1 G40 G17 G49 G80
G54 G64
M3 S16000
G4 P3
(Finger holes, one circle at each of two depths)
G0 Z.5
G0 X3. Y2.25
G1 Z-.25 F30.
G12 I.375 F80.
G1 Z-.52 F30.
G12 I.375 F80.
G0 Z.5
G0 X9.
G1 Z-.25 F30.
G12 I.375 F80.
G1 Z-.52 F30.
G12 I.375 F80.
G0 Z.5
(Dowels)
G0 X.75 Y.75
M98 P200 L3
M5
G0 X0 Y0
M30

O200
G91
G98 G83 X0 Y0 Z-.7 R-.45 Q.2 F20.
G0 X5.25
G98 G83 X0 Y0 Z-.7 R-.45 Q.2 F20.
G80 G0 X-5.25 Y1.5
G90
M99
