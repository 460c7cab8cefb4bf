(machine: fadal-4020)
(set: tools.2.diameter="0.5 in")
(Round pockets. Diameter 3, tool radius .25: to 1.25. With R1 .05 the flat is .2, rings at most)
(.4 apart: four, .3125 apart. All arcs are tangent and of one sense, so half circles join sides.)
M6 T2
G90 G0 S8000 M3 E1 X1. Y2.
H2 D2 Z.1 M8
G1 Z-.2 F10.
L9801 R0+20. R1+.05 R2+3. (= arc ccw center X1.15625 Y2 radius .15625 sweep 180 to X1.3125 Y2 feed 20 | arc ccw center X1 Y2 radius .3125 sweep 360 to X1.3125 Y2)
(= arc ccw center X.84375 Y2 radius .46875 sweep 180 to X.375 Y2 | arc ccw center X1 Y2 radius .625 sweep 360 to X.375 Y2)
(= arc ccw radius .78125 sweep 180 to X1.9375 Y2 | arc ccw radius .9375 sweep 360 | arc ccw radius 1.09375 sweep 180 to X-.25 Y2)
(= arc ccw center X1 Y2 radius 1.25 sweep 360 to X-.25 Y2 | arc ccw center X.375 Y2 radius .625 sweep 180 to X1 Y2 Z-.2)
L9901 R0+20. R1+.05 R2+1. (= arc cw center X1.125 Y2 radius .125 sweep 180 to X1.25 Y2 | arc cw center X1 Y2 radius .25 sweep 360 | arc cw radius .125 sweep 180 to X1 Y2)
(A second pass by the count.)
L9802 R0+20. R1+.05 R2+1. (= arc ccw radius .125 sweep 180 to X1.25 Y2 | arc ccw radius .25 sweep 360 | arc ccw sweep 180 to X1 Y2 | arc ccw sweep 180 to X1.25 | arc ccw sweep 360 | arc ccw sweep 180 to X1 Y2)
(Bore milling, three times round to the diameter of R1.)
L9403 R0+15. R1+1.5 (= arc ccw center X1.25 Y2 radius .25 sweep 180 to X1.5 Y2 feed 15 | arc ccw center X1 Y2 radius .5 sweep 360 x3 | arc ccw radius .25 sweep 180 to X1 Y2)
L9501 R0+15. R1+1.5 (= arc cw center X1.25 Y2 radius .25 sweep 180 to X1.5 Y2 | arc cw radius .5 sweep 360 | arc cw radius .25 sweep 180 to X1 Y2)
G90 G0 Z.1
H0 Z0
M2
