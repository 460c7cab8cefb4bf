(machine: linuxcnc-mill)
; Arcs in the three planes and a centre in coordinates of the part by G90.1.
G21 G90 G94 G40 G49 G17
T1 M6
S6000 M3
G0 X0 Y0 Z5
G1 Z0 F300
G2 X20 Y20 I20 J0 F600      ; XY, a quarter
G90.1 G3 X40 Y40 I20 J40    ; the same size, its centre at X20 Y40
G91.1 G18 G3 X50 Z-10 I0 K-10
G19 G2 Y50 Z0 J10 K0
G17 G1 X60
G0 Z20
M5
M2
