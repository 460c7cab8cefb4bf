%
O9101
(= none | ! CH729 "called with D, X and Y")
(machine: fanuc-30i)
(Arguments in words and loops, what the macro sets itself left out.)
#1=1
WHILE[#1LE#7]DO1
G91 G1 X[#24/#7] Y-#25 F100. (= none)
#1=#1+1
END1
G90
IF[#4001EQ1]THEN #2=#1
M99
%
