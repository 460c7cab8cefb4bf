%
(machine: fanuc-30i)
(set: work_offsets.G55.X="-100 mm")
(set: macros.variables.150001=7)
O1
(System variables of later controls from #100001 on, fifty numbers for each sort; others are said.)
G21 G17 G90 G94 S1000 M3
G54 G0 X11. Y12. Z13.
G1 F100.
X#100002 (= line to X12)
X#[100100+3] (= line to X13)
#100406=-5. (THE SIXTH AXIS OF G55)
#1=#100401
Y#1 (= line to Y-100)
#100401=-50.
Y#5241 (= line to Y-50)
#101051=3. (G54.1 P2)
Y#7021 (= line to Y3)
#98000=4.
Y#98000 (= line to Y4)
Y#150001 (= line to Y7)
#150001=8.
Y#150001 (= line to Y8)
Y#150002 (= none | ! CH705 "#150002" "PS0115" "[macros]")
#100251=1. (= ! CH705 "#100251")
N100000 Y9. (= line to Y9)
M30
%
