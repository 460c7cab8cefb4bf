(machine: fadal-4020)
(Holes at a radius by a loop over the angle: 4 holes on a circle of radius 2 about X1 Y1.)
S1000 M3
G90 G0 X0 Y0 Z.1
#V1=4 ' holes
#V2=2 ' radius
#V5=0
#:HOLE
#R1=1+V2*COS(V5*360/V1)
#R2=1+V2*SIN(V5*360/V1)
G0 X+R1 Y+R2 (= rapid to X3 Y1 | rapid to X1 Y3 | rapid to X-1 Y1 | rapid to X1 Y-1)
G1 Z-.5 F10. (= line to Z-.5 | line to Z-.5 | line to Z-.5 | line to Z-.5)
G0 Z.1 (= rapid to Z.1 | rapid to Z.1 | rapid to Z.1 | rapid to Z.1)
#V5=V5+1
#IF V5<V1 THEN GOTO :HOLE
M2
