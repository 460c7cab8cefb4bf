(machine: mitsubishi-m700)
(P of a full circle are all its turns; manual 6.6, 3. An end near the start differs by that angle alone.)
G21 G17 G90 S1000 M3
G0 X0 Y0 Z0
G1 F100.
G3 I-10. Z-5. P2 (= helix ccw center X-10 Y0 radius 10 sweep 720 to X0 Y0 Z-5)
G3 I-10. Z-6. P1 (= helix ccw radius 10 sweep 360 to X0 Y0 Z-6)
G3 I-10. Z-7. P0 (= helix ccw radius 10 sweep 360 to X0 Y0 Z-7)
G3 I-10. Z-8. (= helix ccw radius 10 sweep 360 to X0 Y0 Z-8)
G3 X-.001 Y.141 I-10. Z-9. P1 (= helix ccw sweep 360.8079)
G3 X0 Y0 I-9.999 J-.141 Z-10. P1 (= helix ccw sweep 719.1921)
M30
