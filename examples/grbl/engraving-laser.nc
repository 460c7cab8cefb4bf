(machine: grbl)
; A badge cut with a laser: M4 gives power by speed, S in each cut
G21 G90 G94
M4 S0
G0 X0 Y0
G1 X40 S600 F1500
G1 Y20
G1 X0
G1 Y0
G0 X10 Y10 S0
G2 X10 Y10 I5 J0 S350 F2400
G0 X0 Y0 S0
M5
