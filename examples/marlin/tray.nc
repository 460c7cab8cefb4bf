;(machine: marlin-router)
; A tray for small parts: a pocket of two levels and its outline, for a router with Marlin.
; One command a line; each G0 has its feed, as the firmware moves G0 and G1 alike.
G21
G90
G28 X Y
; the corner of the work
G92 X0 Y0 Z0
M3 S10000
G4 S3
M117 Pocket
G0 Z5 F600
G0 X15 Y15 F2400
G1 Z-1.5 F150
G1 X65 F900
G1 Y18
G1 X15
G1 Y21
G1 X65
G1 Y24
G1 X15
G1 Z-3 F150
G1 Y15 F900
G1 X65
G1 Y24
G1 X15
G0 Z5 F600
M117 Outline
G0 X10 Y-1.5 F2400
G1 Z-2 F150
G1 X70 F900
G3 X81.5 Y10 I0 J11.5
G1 Y30
G3 X70 Y41.5 I-11.5 J0
G1 X10
G3 X-1.5 Y30 I0 J-11.5
G1 Y10
G3 X10 Y-1.5 I11.5 J0
G0 Z5 F600
M5
M400
G0 X0 Y0 F2400
M117 Done
