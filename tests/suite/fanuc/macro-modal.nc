%
O0001 (MACRO B: MODAL CALLS)
(machine: fanuc-30i)
(units: mm)
(set: work_offsets.G54.X = -50 mm)
(set: work_offsets.G55.X = -100 mm)
(set: tools.2.length = 50 mm)
(set: tools.2.diameter = 10 mm)
(set: settings.No. 6004#0 = 1)
N1 G21 G90 G17 G94 S1000 M3 F100. G0 X0 Y0
(Nested: the last one is called first; its moves trigger the other.)
N2 G66 P9201 Z-1.
N3 G66 P9202 Z-2.
N4 X10. (= rapid to X10)
N5 G67
N6 X20. (= rapid to X20)
N7 G67
N8 X30. (= rapid to X30)
(G66.1: every block calls, its words are the arguments.)
N9 G66.1 P9203
N10 X1. Y2. (= none)
N11 X3. (= none)
N12 G67
N13 X40. (= rapid to X40)
(System variables as a Fanuc numbers them.)
POPEN
DPRNT[#5221[30]#5241[30]#11002[23]#13002[23]] (= > "- 50-100 50.000  5.000")
#3=ATAN[-1]/[-1]
DPRNT[#3[30]] (= > "-135")
#13002=4.
#12002=.1
DPRNT[#13002[13]#12002[13]] (= > " 4.000 0.100")
#4=#4001
#5=#4003
G91 G1 X1. (= line to X41)
G#4 G#5 X42. (= rapid to X42)
DPRNT[#4001[20]#4003[20]#4012[20]#4014[20]#4115[40]] (= > "  0 90 67 54    1")
#2501=-3.
DPRNT[#5221[10]#2501[10]] (= > "-3-3")
PCLOS
M30
O9201
Y#26 (= rapid to Y-1 | rapid to Y-1)
M99
O9202
Z#26 (= rapid to Z-2)
M99
O9203
POPEN
DPRNT[#24[10]#25[10]] (= > " 1 2" | > " 3 0")
PCLOS
M99
%
