(machine: linuxcnc-mill)
; A round pocket: a helix of four turns by P, then a finishing turn.
G21 G17 G90 G94 G40 G49 G64 P0.01
T1 M6
S8000 M3
G0 X10 Y0 Z5
G1 Z0 F200
G3 X10 Y0 I-10 Z-4 P4 F600
G3 I-10
G1 X0 F1000
G0 Z5
M5
M2
