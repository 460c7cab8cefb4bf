%
O153
(machine: haas-vf2)
(set: tools.1.diameter="0.5 in")
(What stops a pocket. None of these blocks moves.)
T1 M06
G00 G90 G17 G40 G49 G54 X1. Y0.7 S2000 M03
G43 H01 Z0.1 M08
G01 F10.
G150 P1 X1. Y0.7 Z-0.2 R0.1 J0.4 G41 (= none | ! CH822 "before the first D")
G150 X1. Y0.7 Z-0.2 R0.1 J0.4 G41 D01 (= none | ! CH823 "without P" "alarm 314")
G150 P999 X1. Y0.7 Z-0.2 R0.1 J0.4 G41 D01 (= none | ! CH823 "N999" "O999" "alarm 314")
G150 P1 X1. Y0.7 Z-0.2 R0.1 J0.4 G42 D01 (= none | ! CH824 "G42 with a counter-clockwise" "alarm 370")
G150 P1 X1. Y0.7 Z-0.2 R0.1 J0.4 D01 (= none | ! CH825 "without G41 or G42")
G150 P1 X1. Y0.7 Z-0.2 R0.1 G41 D01 (= none | ! CH825 "one stepover")
G150 P1 X1. Y0.7 Z-0.2 R0.1 I0.3 J0.3 G41 D01 (= none | ! CH825 "one stepover")
G150 P1 X1. Y0.7 R0.1 J0.3 G41 D01 (= none | ! CH825 "without its levels")
G150 P1 X1. Y0.7 Z0.2 R0.1 J0.3 G41 D01 (= none | ! CH825 "0.2 in is not below")
G150 P1 X1. Y0.7 Z-0.2 R0.1 Q0 J0.3 G41 D01 (= none | ! CH825 "Q")
G150 P1 X1. Y0.2 Z-0.2 R0.1 J0.3 G41 D01 (= none | ! CH821 "0.2 in from the wall" "needs 0.25 in")
G150 P1 X3. Y0.7 Z-0.2 R0.1 J0.3 G41 D01 (= none | ! CH824 "outside")
G150 P2 X1. Y0.7 Z-0.2 R0.1 J0.4 G41 D01 (= none | ! CH824 "ends 0.5 in away from its start" "alarm 370")
G150 P3 X1. Y0.7 Z-0.2 R0.1 J0.4 G41 D01 (= none | ! CH824 "back to the start hole")
G150 P4 X1. Y0.7 Z-0.2 R0.1 J0.4 G41 D01 (= none | ! CH824 "crosses or touches itself at X 1 in, Y 0.5 in")
G150 P5 X1. Y0.7 Z-0.2 R0.1 J0.4 G41 D01 (= none)
G150 P6 X1. Y0.7 Z-0.2 R0.1 J0.4 G41 D01 (= none)
G150 P7 X1. Y0.7 Z-0.2 R0.1 J0.4 G41 D01 (= none)
G18
G150 P1 X1. Y0.7 Z-0.2 R0.1 J0.4 G41 D01 (= none | ! CH825 "only in G17")
G12 I1. D01 (= none | ! CH825 "only in G17")
G17
G12 D01 (= none | ! CH825 "without I")
G12 I0.25 D01 (= none | ! CH821 "I is 0.25 in" "radius is 0.25 in")
G13 I0.5 K0.4 Q0.1 D01 (= none | ! CH821 "K is 0.4 in" "I is 0.5 in")
G13 I0.5 K1. D01 (= none | ! CH825 "go together")
G13 I0.5 Q0.1 D01 (= none | ! CH825 "go together")
G12 I1. D09 (= none | ! CH822 "tool 9")
G13 I0.5 K1. Q0.00001 D01 (= none | ! CH211 "10000 circles")
(Told, and milled.)
G150 P1 X1. Y0.7 Z-0.1 R0.1 J0.6 G41 D01 (= line x11 | ! CH826 "ridges 0.1 in wide")
G00 Z0.1
M30
N1 G01 X2. Y0.75
Y1.5
X0
Y0
X2.
Y0.75
M99
N2 G01 X2. Y0.75
Y1.5
X0
Y0
X2.
Y0.25
M99
N3 G01 X2. Y0.75
Y1.5
X0
Y0.7
X1.
M99
N4 G01 X2. Y0
Y1.
X0 Y0
Y1.
X2. Y0
M99
N5 G01 X2. Y#1 (= ! CH824 "macro variables")
M99
N6 G01 X2. Y0
G00 Y1. (= ! CH824 "G0 in the outline")
M99
N7 G01 X2. Y0
G03 X2. Y1. I1. (= ! CH824 "off its circle")
M99
%
