%
O9001 (TOOL CHANGE)
(= none | ! CH729 "called with T")
(machine: fanuc-30i)
G91 G28 Z0 (= none)
M6 T#20 (= none)
G90
IF[#20EQ0]GOTO9
N9 M99
%
