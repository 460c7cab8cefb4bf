(machine: fadal-4020)
(The radius is the value of another parameter; a stale R0 makes no arc of a later block.)
S1000 M3
G90 G0 X0 Y0 Z0
R1+1.
G1 F20.
X1. Y1. R0+R1 G3 (= arc ccw center X0 Y1 radius 1 sweep 90 to X1 Y1)
X2. (= line to X2 Y1)
R2-.5
X+R1 Y+R2 (= line to X1 Y-.5)
M2
