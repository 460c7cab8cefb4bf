%
O1 (ARCS, RADII, LEVELS OF CYCLES, DWELLS: NOTHING ELSE IS SAID OF THEM)
(machine: fanuc-30i)
G21 G17 G90 G94 S1000 M3
G0 X0 Y0 Z5.
G1 Z0 F100. (= line to Z0)
G4 P#510 (= none | ! CH726 "#510" | ! CH730 "`P` is computed from #510")
G2 X2. Y0 R#511 (= none | ! CH727 "`R` is computed from #511")
G1 X0 Y0 (= line to X0 Y0)
G3 X#512 Y2. I1. J0 (= none)
G1 X0 Y0 (= line to X0 Y0)
G2 X2. Y0 I#513 J0 (= none)
G1 X0 Y0 (= line to X0 Y0)
G0 Z5. (= rapid to Z5)
G81 X1. Z#514 R1. F100. (= none)
X2.
G80
G0 Z5. (= rapid to Z5)
G99 G83 X3. Y0 Z-3. R1. Q#515 (= none)
G80
G10 L2 P1 X#516 (= none)
G0 X0 Y0 Z5. (= rapid to X0 Y0 Z5)
M30
%
