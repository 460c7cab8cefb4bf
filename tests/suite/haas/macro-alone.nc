%
O09100 (POCKET)
(= none | ! CH729 "called with A, B and X")
(machine: haas-vf2)
IF [ #1 LE 0. ] THEN #3000= 7 (A MISSING) (= none)
#33= #2 / #1
G01 X[ #24 + #33 ] F10. (= none)
M99
%
