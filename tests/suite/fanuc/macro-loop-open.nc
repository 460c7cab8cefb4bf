(machine: fanuc-30i)
(units: mm)
(A loop without its END is told where it begins, also while its condition holds.)
G90 G0 X0
#1=0
WHILE[#1LT3]DO1 (= ! CH712 "DO1 has no END1 below it")
G0 X#1 (= rapid to X0)
#1=#1+1
M30
