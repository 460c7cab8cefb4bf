(machine: mitsubishi-m700)
(units: mm)
(M700V 6.13: no spiral and no cone while coordinates are mirrored or scaled.)
G21 G17 G90 G94 S1000 M3 F100
G0 X10. Y0. Z0.
G2.1 X20. Y0. I-5. P1 (= spiral cw to X20 Y0)
G0 X10. Y0.
G51.1 X0
G2.1 X20. Y0. I-5. P1 (= line to X-20 Y0 | ! CH447 "mirrored" "P34")
G3.1 X30. Y0. I-5. P0 (= line to X-30 Y0 | ! CH447)
G2 X20. Y0. I-5. (= arc ccw to X-20 Y0)
G50.1
G0 X10. Y0.
G51 X0 Y0 Z0 P2.
G2.1 X20. Y0. I-5. P1 (= line to X40 Y0 | ! CH447 "scaled" "P34")
G50
G0 X10. Y0.
G2.1 X20. Y0. I-5. P1 (= spiral cw to X20 Y0)
M30
