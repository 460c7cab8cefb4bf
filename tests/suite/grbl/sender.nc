(machine: grbl)
(The sender keeps M6 from GRBL: said once.)
G21 G90
T1 M6 (= ! CH314 "has no tool change")
G0 X5 (= rapid to X5)
T2 M6
G0 X6 (= rapid to X6)
