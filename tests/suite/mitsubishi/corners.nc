(machine: mitsubishi-m700)
(Corner chamfering and corner R, between lines and arcs.)
G21 G17 G90 G94 S1000 M3
G0 X0 Y0 Z0
G1 X20. ,C4. F300. (= line to X16 Y0 | line to X20 Y4 feed 300)
Y20. ,R5. (= line from X20 Y4 to X20 Y15 | arc ccw to X15 Y20 center X15 Y15 radius 5.00)
X0 (= line from X15 Y20 to X0 Y20)
(Down to a quarter about X20 Y10, which begins to the right at X20 Y0: the rounding of 2 stands inside, 8 from)
(its centre and 2 beside the line: Y = 10 - root 48.)
G0 X14. Y20.
G1 Y2. ,R2. (= line to X14 Y3.071797 | arc ccw to X15 Y1.339746 radius 2.00)
G3 X30. Y10. R10. (= arc ccw from X15 Y1.339746 to X30 Y10)
(No rounding where the moves go on in one direction.)
G1 Y20. ,R2. (= line to X30 Y20)
Y30. (= line to X30 Y30)
(The other planes.)
G0 X0 Y0 Z0
G18 G1 X10. ,R2. (= line to X8 Z0 | arc cw plane zx to X10 Z2 radius 2.00)
Z10. (= line from X10 Z2 to Z10)
G19 Z20. ,C3. (= line to Z17 Y0 | line to Z20 Y3)
Y10. (= line from Z20 Y3 to Y10)
G17
(What cannot be.)
G1 X20. ,R1. (= line to X20 Y10 | ! CH428 "a dwell" "P382")
G4 P10
Y20. ,R11. (= line to X20 Y20 | ! CH437 "11 mm" "at most 10 mm")
X0 ,R1. (= line to X0 Y20 | ! CH429 "rapid" "P382")
G0 Y0
M30
