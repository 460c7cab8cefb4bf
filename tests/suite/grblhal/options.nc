(machine: grblhal)
(set: settings."tool table"="on")
(set: settings.expressions="on")
(set: tools.1.length="20 mm")
(A build with a tool table and expressions.)
G21 G90 G54
T1 M6 G43 H1
G0 Z30 (= rapid to Z30)
#1 = 5
G0 X[#1 * 2] (= rapid to X10)
o100 repeat [2]
G91 G0 X#1
o100 endrepeat
G90
G0 X0 (= rapid to X0)
G53 G0 Z10 (= rapid to Z-10)
M30
