%
O00002 (HAAS MACROS: SYSTEM VARIABLES)
(machine: haas-vf2)
(set: work_offsets.G54.X = -10 in)
(set: work_offsets.G54.Y = -5 in)
(set: work_offsets.G54.Z = -12 in)
(set: tools.3.length = 4.5 in)
(set: tools.3.diameter = .5 in)
N1 G20 G90 G17 G94 G40 G80 G54 T3 M6 S1500 M3 F12.5 G0 X1. Y2.
G43 H3 Z1.
DPRNT[#5001[24]*#5002[24]*#5003[24]] (= > "1.0000 2.0000 1.0000")
(Machine: work offset and tool length added; work position: the length.)
DPRNT[#5021[24]*#5022[24]*#5023[24]] (= > "-9.0000 -3.0000 -6.5000")
DPRNT[#5041[24]*#5042[24]*#5043[24]] (= > "1.0000 2.0000 5.5000")
#1=#5043-#5003
DPRNT[#1[24]*#5083[24]*#2003[24]*#2403[24]] (= > "4.5000 4.5000 4.5000 0.5000")
(Modal codes: motion, plane, distance, feed mode, units, length, offset.)
DPRNT[#4001[20]*#4002[20]*#4003[20]*#4005[20]*#4006[20]*#4008[20]*#4012[20]] (= > "0 17 90 94 20 43 54")
DPRNT[#4109[23]*#4119[40]*#4120[20]*#3026[20]*#4111[20]] (= > "12.500 1500 3 3 3")
(Work offsets read and written.)
DPRNT[#5221[24]*#5223[24]] (= > "-10.0000 -12.0000")
#5221=#5221+1.
DPRNT[#5001[24]*#5021[24]] (= > "0.0000 -9.0000")
X1. (= rapid from X0 to X1)
#5241=3.
#14001=4.
DPRNT[#5241[24]*#14001[24]*#7001[24]] (= > "3.0000 4.0000 4.0000")
(A length written while it is in force.)
#2003=#2003+.5
DPRNT[#5003[24]*#5023[24]] (= > "0.5000 -6.5000")
#2601=.002
DPRNT[#2601[24]] (= > "0.0020")
(A skip move goes to its end, which #5061 and on show, the tool length included.)
G31 Z-.25 F5. (= line to Z-.25 feed 5 | ! CH723)
DPRNT[#5063[24]*#5061[24]] (= > "4.7500 1.0000")
G31 (= none)
(Inputs are given by the machine file, else 0.)
#1=#1001 (= ! CH719 "#1001")
#4001=1 (= ! CH706)
#6000=1 (= ! CH705)
IF[#3026NE4]THEN #3000=7(WRONG TOOL) (= ! CH716 "1007 WRONG TOOL")
M30
%
