(machine: fanuc-6m)
(The path beside two angles, with cutter offsets worked out by hand: .144 and .067 for a .25 radius.)
N1 G90 G00 X-0.25 Y0. S1000 M03
N2 G01 X-0.25 Y1.144 F10. (= line to X-.25 Y1.144)
N3 G01 X1.665 Y2.25 (= line to X1.665 Y2.25 length 2.2114)
N4 X4.25 (= line to X4.25 Y2.25)
N5 M30
