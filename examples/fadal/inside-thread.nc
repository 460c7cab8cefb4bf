(machine: fadal-4020)
(Inside thread 1 1/16 - 28, cut upwards with a single tooth of .75. The path is the tool's centre:)
(.53125 - .375 = .15625. Fifteen leads of 1/28 lift it from -.5 to .0355.)
M6 T5 (SINGLE POINT THREAD MILL .75
G90 G0 S10000 M3 E1 X0 Y0
H5 Z.1 M7
Z-.5 G1 F50.
X.1562 F25.
G91
I-.1562 G3 Z.0357 L15
G90
X0
Z.1 G0
M5 M9
G90 G0 H0 Z0
M2
