%
O9100 (BOLT HOLES: CALLED WITH X, Y, R, Z AND F)
(= none | ! CH729 "called with F, R, X, Y and Z; run alone it does nothing")
(machine: fanuc-30i)
(A macro without its caller: nothing is run, no alarm of its own, no division by an argument that is not there.)
IF[#24EQ#0]GOTO900 (= none)
#1=#25/#18 (= none)
G0 X#24 Y#25 (= none)
G1 Z-#26 F#9 (= none)
M99
N900#3000=1(X MISSING) (= none)
M99
%
