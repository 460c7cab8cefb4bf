(machine: fadal-4020)
(set: tools.1.diameter="0.375 in")
(A rectangular pocket and a round one by fixed routines, each entered by a helix.)
L100 (ONE TURN DOWN AND BACK TO THE MIDDLE
G91 X.15 G1 F20.
I-.15 G3 Z-.1
I-.15 G3
X-.15
M17
M30
(MAIN PROGRAM
M6 T1 (END MILL 3/8, CORNERS .01
G0 G90 S8000 M3 E1 X2. Y1.5
H1 D1 Z.1 M8
G1 Z0 F10.
L101
G90
L9601 R0+40. R1+.01 R2+3. R3+2.
G0 Z.1
X5. Y1.5
G1 Z0 F10.
L101
G90
L9801 R0+40. R1+.01 R2+2.
M5 M9
G90 G0 H0 Z0
M2
