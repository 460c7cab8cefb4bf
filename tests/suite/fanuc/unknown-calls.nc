%
O1 (CALLS)
(machine: fanuc-30i)
G21 G17 G90 G94 S1000 M3
G0 X0 Y0 Z0
M98 P#530 (= ! CH726 "#530, #531, #532, #533 and #534" | ! CH727 "`P` is computed from #530")
G65 P#531 X5. (= none)
M98 P8000 L#532
G65 P8001 X#533 Y3.
X#534 Y0 (= rapid to Y0)
M30
O8000
G91 X1. (= rapid)
G90
M99
O8001
IF[#25EQ#0]GOTO9
Y#25 (= rapid to Y3)
X#24 (= none)
N9 M99
%
