(machine: fanuc-30i)
(set: settings.offset_memory = "C")
(set: tools.3.length = 50 mm)
(units: mm)
(Offset memory C: the old numbers are wear, and geometry from 2201 on, as 10001 and 11001.)
G21 G17 G90 G94 S1000 M3 F100
G10 L11 P3 R0.5
G0 X#2003 (= rapid to X0.5)
X#10003 (= rapid to X0.5)
Y#2203 (= rapid to Y50)
Y[#11003+1] (= rapid to Y51)
#2203=60.
Y#11003 (= rapid to Y60)
M30
