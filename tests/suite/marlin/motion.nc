;(machine: marlin-router)
; The feed of power-on is 1500 mm/min, and G0 and G1 have one.
G0 X10 ; (= rapid to X10 feed 1500)
G1 X20 ; (= line to X20 feed 1500)
G0 Z5 F300 ; (= rapid to Z5 feed 300)
G1 X30 ; (= line to X30 feed 300)
G1 F0 X31 ; no feed of zero (= line to X31 feed 300 | ! CH406 "does nothing here")
G91
G1 X-1 Y2 ; (= line to X30 Y2)
G90
; arcs
G2 X40 Y2 I5 J0 ; (= arc cw center X35 Y2 radius 5 sweep 180 to X40 Y2)
G3 X30 R5 ; (= arc ccw center X35 Y2 radius 5 sweep 180)
G2 I5 ; (= arc cw center X35 radius 5 sweep 360)
G2 X40 Y2 Z4 I5 ; (= helix cw center X35 radius 5 sweep 180 to X40 Y2 Z4)
G3 I-5 P2 ; P counts on builds with ARC_P_CIRCLES (= arc ccw radius 5 sweep 360)
G2 X50 ; (= line to X50 | ! CH405 "neither a centre nor a radius")
G1 X40
; the end is 0.03 mm off the circle: the arc keeps its radius to the ray of the end
G2 X50.03 Y2 I5 J0 ; (= arc cw center X45 Y2 radius 5 sweep 180 to X50 Y2 | line to X50.03 Y2)
G1 X50
G18
G3 X60 Z4 I5 K0 ; (= arc ccw center X55 Z4 radius 5 sweep 180)
G17
; inch
G20
G1 X1 F10 ; (= line to X25.4 feed 254)
G21
; dwells
G4 P500 ; (= dwell 0.5)
G4 S2 ; (= dwell 2)
G4 P500 S1 ; S counts (= dwell 1)
G4 ; (= dwell 0)
M400
; modes of the motion
G80
X5 ; (= rapid to X5 | ! CH813 "no motion code is active")
G1 X6
