;(machine: marlin-router)
;(How Marlin takes a line: one command with its words.)
G21
G90
G0 X10 Y5 F3000 ; (= rapid to X10 Y5 feed 3000)
  G1   X 12.5   Y5 F600 ; blanks (= line to X12.5 Y5 feed 600)
G1X20Y-.5 ; (= line to X20 Y-0.5)
N10 G1 X21*87 ; the checksum is passed over (= line to X21 Y-0.5)
N11G1X22 ; (= line to X22)
N12
X23 Y1 ; the motion before goes on (= line to X23 Y1)
G1 X24 X25 ; the last counts (= line to X25 | ! CH106 "more than once")
G1 X Y4 ; (= line to X25 Y4 | ! CH109 "no number")
; numbers without a point are units
G1 X100 ; (= line to X100)
G90 G1 X5 ; the first command takes the line (= ! CH307 "G1 does nothing here")
G1 X6 G90 ; what is active already is not missed (= line to X6 | ! CH307 "G90 does nothing here")
G1 X7 G91 ; (= line to X7 | ! CH307 "G91 does nothing here")
G1 X8 ; G91 did nothing (= line to X8)
M117 Moving to X99 G1 X50 ; a text
M118 E1 Done: 50% (30 s)
M0 Put in tool 2, then go on ; (= stop)
M0 S5 Ready ; (= stop)
M1 ; (= stop)
M400 X50 ; its words are no move (= ! CH304 "X")
g1 x9 ; this build reads capital letters (= ! CH301 "begins with no command")
G1 x9 Y9 ; (= line to X8 Y9 | ! CH304 "lower-case")
G1 X9 (a comment) Y10 ; no comment: its letters are passed over (= line to X9 Y10 | ! CH304 "lower-case")
