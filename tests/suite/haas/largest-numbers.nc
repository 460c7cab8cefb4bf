%
O01234
(machine: haas-vf2)
(units: mm)
(The largest numbers: 200 tools and offsets. One code of the spindle in a block, and a speed for it.)
T201 M6 (= ! CH303 "Haas NGC mill has no T201: the last one is T200")
T200 M6
G21 G90 G17 G40 G54
M3
G0 X0. Y0.
G43 Z5. H200 (= ! CH603)
G1 X10. F200. (= line to X10 | ! CH413 "the spindle has no speed")
N123456789 X20. (= line to X20 | ! CH311 "above the largest number, N99999999")
S1000 M3 M5 (= ! CH302 "M3 and M5 cannot be in one block")
S1000 M3
G43 Z5. H201 (= ! CH303 "no H201" | ! CH604 | ! CH611)
G10 L2 P7 X0. (= ! CH303 "no work offset P7")
(A feed per minute with G95: 200 mm/rev at 1000 rpm.)
G95 G1 X30. F200. (= line to X30 | ! CH407 "200000 mm/min")
M30
%
