(machine: fadal-4020)
(A two inch bore from solid with a 3/4 end mill. The path is the tool's centre, radius 1 - .375 =)
(.625: three turns of .3, one to the floor, two turns to finish. L repeats its line.)
M6 T1 (END MILL 3/4, CENTER CUTTING
G90 G0 S5000 M3 E1 X2. Y-2.
H1 Z.05 M8
Z0 G1 F25.
X2.625
G91 I-.625 G3 Z-.3 L3
I-.625 Z-.13
I-.625 L2 (G3 IS STILL ARMED
G90 X2.
Z.1 G0
M5 M9
G90 G0 H0 Z0
M2
