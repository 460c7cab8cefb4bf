(machine: linuxcnc-mill)
; Outside thread M30x2 with a single tooth of 12: the centre runs on 13.774 + 6 = 19.774.
; P12 turns twelve times in one block while Z goes 24 down.
G21 G90 G17 G94 G40 G49 G64 P0.005
T3 M6
S2500 M3
G0 X-30 Y0 Z5
Z2
G1 X-19.774 F400
G2 X-19.774 Y0 I19.774 Z-22 P12
G1 X-30
G0 Z5
M5
M2
