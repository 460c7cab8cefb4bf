(machine: fanuc-30i)
(What a rounding or a chamfer cannot do: the corner stays as it is.)
G21 G17 G90 G94 S1000 M3
G0 X0 Y0 Z0
G1 X10. ,R6. F300. (= line to X10 Y0 | ! CH437 "6 mm" "move of 10 mm" "next of 5 mm" "at most 5 mm" "PS0055")
Y5. ,C7. (= line to X10 Y5 | ! CH437 "a chamfer of 7 mm" "at most 5 mm")
X0. (= line to X0 Y5)
(Both corners of a move of 10 take 6 from it.)
X20. ,R6. (= line to X14 Y5 | arc ccw to X20 Y11)
Y15. ,R6. (= line from X20 Y11 to Y15 | ! CH437 "at most 4 mm")
X0. (= line to X0 Y15)
X10. ,R1. (= line to X10 Y15 | ! CH437 "goes back")
X5.
G0 X0 Y0
G1 X10. ,R10. (= arc ccw from X0 Y0 to X10 Y10)
Y10. ,R1. (= none | ! CH437 "takes all of this move")
X5.
(What comes next.)
Y20. ,R1. (= line to X5 Y20 | ! CH428 "not in the plane of X and Y" "PS0051")
Z1. (= line to Z1)
Y30. ,R1. (= line to X5 Y30 | ! CH429 "rapid" "PS0052")
G0 X0 (= rapid to X0)
G1 Y40. ,R1. (= line to X0 Y40 | ! CH428 "a block without a move")
M8
X10. ,R1. (= line to X10 Y40 | ! CH428 "a dwell")
G4 P10
G4 P10
Y30. ,R1. (= line to X10 Y30 | ! CH428 "plane")
G18 X20.
G17
Y20. ,R1. (= line to X20 Y20 | ! CH428 "no length")
Y20.
X30. ,R1. (= line to X30 Y20 | ! CH428 "a block without a move")
G92 X0 Y0
G1 X5. Y0 ,R1. (= line to X5 Y0 | ! CH429 "cycle")
G81 Y10. Z-5. R1.
G80
(The block itself.)
G1 X10. ,R1. ,C1. (= line to X10 | ! CH427 "one rounding or one chamfer")
G1 X15. ,R-1. (= line to X15 | ! CH303 "negative")
G0 X20. ,R1. (= rapid to X20 | ! CH427 "a rapid")
G1 Z-2. ,R1. (= line to Z-2 | ! CH427 "not in the plane")
G1 F100. ,R1. (= none | ! CH427 "no move")
G4 P10 ,R1. (= ! CH427)
G81 X0 Y5. Z-5. R1. ,R1. (= ! CH427 "cycle")
G80
(Chamfers on arcs are not carried out.)
G0 X0 Y0
G1 X10. ,C1. (= line to X10 Y0 | ! CH312 "an arc")
G2 X20. I5. (= arc cw to X20 Y0)
G1 X30. ,A45. (= line to X30 | ! CH312)
G1 Y5. ,R1. (= line to Y5 | ! CH428 "the program ends")
M30
