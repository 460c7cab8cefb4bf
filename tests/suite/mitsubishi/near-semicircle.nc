(machine: mitsubishi-m700)
(units: inch)
(Parameter 11028: a radius within two increments of half the chord has its centre in the middle.)
G20 G17 G90 G94
G0 X0 Y0 Z0
S1000 M3
G2 X3.9999 R2. F10. (= arc cw center X1.99995 Y0 radius 1.99995 to X3.9999 Y0)
G0 X0
G2 X3.9997 R2. (= arc cw center X1.99985 Y-0.024494 radius 2 to X3.9997 Y0)
M30
