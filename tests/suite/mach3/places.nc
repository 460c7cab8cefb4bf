(machine: mach3-mill)
(Circular pockets, polar words about the present place, a rotation by A, B and R.)
G21 G17 G90 G94
S1000 M3
F200
G0 X10 Y10 Z0
(Out along X, once round, back: the radius is that of the tool's centre.)
G12 I5 (= line to X15 Y10 feed 200 | arc cw center X10 Y10 radius 5 sweep 360 to X15 Y10 | line to X10 Y10)
G13 I2.5 (= line to X12.5 Y10 | arc ccw center X10 Y10 radius 2.5 sweep 360 | line to X10 Y10)
G12 (= none | ! CH825 "without I")
G12 X5 I5 (= ! CH312 "with axis words" | ! CH304)
G18
G12 I5 (= none | ! CH825 "only in G17")
G17
(Radius 10 at 45 degrees from X10 Y10; an angle alone keeps the radius.)
G0 X10 Y10
G16
G0 X10 Y45 (= rapid to X17.071068 Y17.071068)
G1 Y135 (= line to X2.928932 Y17.071068)
X20 (= line to X-4.142136 Y24.142136)
(Anew from where the tool stands.)
G16
X10 Y0 (= line to X5.857864 Y24.142136)
Z-1 (= line to Z-1)
G91 X1 Y1 (= line | ! CH312 "in G91")
G90
G2 X5 Y90 R20 (= ! CH312 "polar words of arcs and cycles are not followed")
G15
G1 X10 Y10 (= line to X10 Y10)
(A turn about X10 Y10 by 90 degrees.)
G68 A10 B10 R90
G1 X20 Y10 (= line to X10 Y20)
G69
G1 X20 Y10 (= line to X20 Y10)
G68 A0 B0 R30 I1 (= none | ! CH312 "A and B are its centre")
G69
G68 R30 (= none | ! CH312 "without A and B")
G69
G68 X0 Y0 R30 (= none | ! CH312 "A and B are its centre")
G69
(Words are multiplied, about the work zero; the axis that is not named stays where it is.)
G1 X10 Y10 Z0
G51 X2 Y2
G1 X10 Y5 (= line to X20 Y10)
Y10 (= line to X20 Y20)
G91 X5 (= line to X30 Y20)
G90
G2 X20 Y10 I2.5 J0 (= arc cw center X35 Y20 radius 5 to X40 Y20)
G4 P1 (= dwell 1)
G2 X15 Y10 R2.5 (= arc cw | ! CH312 "multiplied")
G81 X5 Y5 Z-2 R1 (= ! CH312 "multiplied")
G80 (= none | ! CH312 "multiplied")
G92 X0 (= none | ! CH433 | ! CH312 "multiplied")
G92.1 (= none | ! CH312 "multiplied")
G51 X2 Y1
G0 X10 Y10
G2 X20 Y10 I5 J0 (= ! CH431)
G51 (= none | ! CH308)
G50
G0 X10 Y10 (= rapid to X10 Y10)
M30
