(machine: mitsubishi-m700)
G21 G17 G90 G94 F100.
S1000 M3
G0 X0. Y0. Z20.
G98 G76 X10. Z-5. R2. I.5 J.2 P100 (= rapid to X10 | rapid to Z2 | line to Z-5 | line to X10.5 Y.2 feed 100 | rapid to Z20 | rapid to X10 Y0)
G84 X20. Z-5. R2. F1.5 ,R1 (= rapid to X20 | rapid to Z2 | line to Z-5 feed 1500 | line to Z2 feed 1500 | rapid to Z20)
G80
M30
