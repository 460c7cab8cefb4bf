(machine: fanuc-lathe-c)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(set: tools.1.diameter="10 mm")
(show: path)
(The contour of the Mitsubishi manual's example, X as a diameter: a cutter of 5 mm radius outside of it.)
G21 G18 G40 G80 G98 G97 S1000 M3
T0101
G0 X100. Z0 C0
G12.1
G1 G42 X40. F200. (= line to X50 Y0)
C10. (= line to X50 Y10)
G3 X20. C20. R10. (= arc ccw to X20 Y25 center X20 Y10 radius 15.00)
G1 X-40. (= line to X-50 Y25)
C-10. (= line to X-50 Y-10)
G3 X-20. C-20. I10. J0 (= arc ccw to X-20 Y-25 center X-20 Y-10 radius 15.00)
G1 X40. (= line to X50 Y-25)
C0 (= line to X50 Y0)
G40 X100. (= line to X100 Y0)
G13.1
M30
