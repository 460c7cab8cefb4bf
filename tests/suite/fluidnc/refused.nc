(machine: fluidnc)
(set: settings."on error"="continue")
(A slash begins no word; a line has 127 characters with blanks and comments; no cycles.)
G21 G90 G17
/G0 X5 (= ! CH313 "begins with a letter")
G0 X5 (= rapid to X5)
G81 X1 Z-1 R1 F100 (= ! CH313 "does not have this word")
G2 I5 F100 (= ! CH313 "needs an axis word")
G43 H1 (= ! CH313 "does not have this word")
A5 (= ! CH313 "does not have this word")
M61 (= ! CH313 "needs is missing")
G0 X6 (a comment that makes this line far too long for the buffer of the control, which counts each of its characters, blanks too) (= ! CH313 "127 characters")
G38.6 Z-5 F50 (= ! CH312 "G38.6")
M30
