(machine: mach3-mill)
(set: settings."G73 Pullback"="0.5 mm")
(set: settings."G04 Dwell in ms"="on")
(G99 at power-on; a dwell that is left out is none; milliseconds of G4 alone by a setting.)
G21 G90 G17 G94
S1000 M3
F100
G0 X0 Y0 Z10
G81 X5 Y5 Z-2 R1 (= rapid to X5 Y5 Z10 | rapid to Z1 | line to Z-2 | rapid to Z1)
X10 (= rapid to X10 Y5 Z1 | line to Z-2 | rapid to Z1)
(Back to the initial level: that before the first of the cycles.)
G98 G82 X15 Z-2 R1 P0.5 (= rapid to X15 Y5 Z1 | line to Z-2 | dwell .5 | rapid to Z10)
G80
G0 Z0
(Up to R first where the tool is below it.)
G82 X20 Z-2 R1 (= rapid to X15 Z1 | rapid to X20 Z1 | line to Z-2 | rapid to Z1)
G99 G73 X25 Z-3 R1 Q2 (= rapid to X25 Z1 | line to Z-1 | rapid to Z-.5 | line to Z-3 | rapid to Z1)
G80
G4 P500 (= dwell .5)
G0 Z10
G84 X30 Z-2 R1 (= ! CH312 "not every version")
M30
