%
O00010 (HAAS MACROS: CALLS)
(machine: haas-vf2)
(set: settings.Parameter 91 = 150)
(set: settings.Parameter 81 = 40)
N1 G20 G90 G17 G94 G40 G80 S1000 M3 F10. G0 X0 Y0
(A call behind THEN; O20 is called, so it is no main program.)
IF [ #1 EQ #0 ] THEN M98 P20
(M99 P jumps in the running program, as a Haas does it.)
#1= 0
N10 #1= #1 + 1
X#1 (= rapid to X1 | rapid to X2)
IF [ #1 LT 2 ] THEN M99 P10
(G150 calls O9010 with arguments, M40 calls O9000 without.)
G150 X3. Y4. (= none)
#24= 7.7
M40
(A local call keeps the variables, a macro call has its own.)
#5= 6.
M97 P100 L2
G65 P30 Z5.
Z#26 (= none)
X[ #100 ] (= rapid to X5)
(A macro calls itself nine deep; the tenth is refused.)
#101= 0
G65 P40
Y[ #101 / 10 ] (= rapid to Y.9)
(A number of turns by L, the arguments set once.)
G65 P50 L2 A1.
(Every copy of a repeated block is counted, and the loop ends.)
M30
N100 X#5 (= rapid to X6 | rapid to X7)
#5= #5 + 1
M99
O00020
X9. (= rapid to X9)
M99
O00030
#100= #26
#26= 99.
M99
O00040
#101= #101 + 1
G65 P40 (= ! CH713 "10 levels deep" "531")
M99
O00050
X#1 (= rapid to X1 | rapid to X2)
#1= #1 + 1
M99
O09010
X#24 Y#25 (= rapid to X3 Y4)
M99
O09000
X#24 (= rapid to X7.7)
M99
%
