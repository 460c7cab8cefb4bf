%
O1 (STATES OF THE MACHINE)
(machine: fanuc-30i)
(set: #1001 = 1)
G21 G17 G90 G94 S1000 M3
G0 X0 Y0 Z0
#1=#5121+#5401 (= ! CH719 "#1000, #3001, #5121 and #5401")
#2=#1000 
IF[#1001EQ1]GOTO10
X99. (= none)
N10 #3=#3001
#3001=0
#3=#3001
X#3 (= none | ! CH727 "#3001")
#4=#3011 (= ! CH724 "not known")
#5=#5501 (= ! CH705 "#5501" "PS0115")
#6=#3900 (= ! CH705 "#3900")
X1. (= rapid to X1)
M30
%
