(machine: haas-vf2)
G20 G90 F10. S900 M3
G0 X0 Y0 (= rapid to X0 Y0)
G1 X1. (= line from X0 to X1 length 1)
M30
