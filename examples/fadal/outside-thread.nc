(machine: fadal-4020)
(Outside thread 1 1/16 - 28: fifteen turns by a line repeat. The path is the tool's centre.)
M6 T5 (SINGLE POINT THREAD MILL .75
G90 G0 S10000 M3 E1 X-1.5 Y0
H5 Z.0357 M7
X-.8844 G1 F25.
G91
I.8844 G2 Z-.0357 L15
G90
X-1.5 G0
M5 M9
G90 G0 H0 Z0
M2
