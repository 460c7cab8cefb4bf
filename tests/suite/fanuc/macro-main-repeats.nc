%
O2
(machine: fanuc-30i)
(A main program that M99 starts again: it names its tool. It is run.)
G21 G17 G90 G94
T1 M6
S1000 M3
#2=#1+1
G0 X#2 Y0 (= rapid to X1 Y0)
M99 (= ! CH204)
%
