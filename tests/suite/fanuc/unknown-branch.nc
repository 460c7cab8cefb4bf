%
O1 (BRANCHES)
(machine: fanuc-30i)
G21 G17 G90 G94 S1000 M3
G0 X0 Y0 Z0
IF[#500EQ#0]GOTO10 (= ! CH726 "#500, #501 and #502" | ! CH728 "#500" "not fulfilled")
X1. (= rapid to X1)
N10 WHILE[#501LT5]DO1 (= ! CH728 "#501")
X99. (= none)
END1
IF[#1EQ#0]GOTO20
X98. (= none)
N20 GOTO[#502+10] (= ! CH727 "the block that GOTO means" "#502")
X2. (= rapid to X2)
IF[#501GT3]GOTO30 (= ! CH728)
#3000=5(WRONG PART) (= ! CH716 "was assumed")
N30 M30
%
