(machine: fanuc-30i)
(set: axes.X.programmed="diameter")
(set: work_offsets.G54.X="-500 mm")
(X is a diameter: 60 across is 30 from the axis. I, R, lengths and feeds are those of the slide.)
G21 G18 G90 G94 S500 M3
G0 X50. Y0 Z5. (= rapid to X50 Z5)
G1 Z-20. F100. (= line to X50 Z-20 length 25.00 feed 100)
X60. (= line to X60 length 5.00 feed 100)
G2 X70. Z-25. I5. K0 (= arc cw to X70 Z-25 center X70 Z-20 radius 5.00 sweep 90.00)
G3 X60. Z-30. R5. (= arc ccw to X60 Z-30 center X60 Z-25 radius 5.00 sweep 90.00)
G91 G1 X-10. (= line to X50 length 5.00)
G92 X100.
G90 X90. (= line from X100 to X90 length 5.00)
#100=#5001+20.
X#100 (= line to X110 length 10.00)
M30
