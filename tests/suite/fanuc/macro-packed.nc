(machine: fanuc-30i)
(units: mm)
(A number may stand right before a statement. Names of variables on the screen move nothing.)
SETVN500[COUNT,DEPTH]
SETVN501[DEPTH (= ! CH704)
#100=1
IF[#100EQ1]GOTO20
G0 X1.
N20#101=10.
N30#102=#101+5.
G0 X#102 (= rapid to X15)
M30
