(machine: linuxcnc-mill)
(units: mm)
(What LinuxCNC itself refuses, each on its line.)
G21 G17 G90 G94 F100
S1000 M3
G0 X0 Y0 Z1
G81 X1 Z-1 (= none | ! CH800)
G80
G81 X1 R1 (= none | ! CH801)
G80
G82 X1 R1 Z-1 (= none | ! CH803)
G83 X1 R1 Z-1 (= none | ! CH802)
G83 X1 R1 Z-1 Q-1 (= none | ! CH802)
G81 X1 R1 Z2 (= none | ! CH805)
G81 X1 R1 Z0 L0 (= none | ! CH808)
G74 X1 R1 Z0 (= rapid to X1 | line to Z0 | line to Z1 | ! CH814)
G80 X2 (= rapid to X2 | ! CH813)
G0 Z5
M2
