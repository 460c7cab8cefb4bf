(machine: fanuc-0i)
(set: settings.offset_memory = "A")
(set: tools.3.length = 50 mm)
(units: mm)
(Offset memory A: one value each, and no numbers beyond.)
G21 G17 G90 G94 S1000 M3 F100
G0 Y#2003 (= rapid to Y50)
#1=#2203 (= ! CH705 "2203")
M30
