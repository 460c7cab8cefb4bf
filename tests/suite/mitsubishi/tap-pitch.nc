(machine: mitsubishi-m700)
(set: tools.1.shape="tap")
(set: tools.1.diameter="8 mm")
(set: tools.1.pitch="1.25 mm")
(set: tools.1.length="100 mm")
(F and S against the pitch of the tap, 1.25 mm; a hole without depth.)
G21 G17 G40 G49 G80 G90 G94
T1 M6
G0 G54 X0. Y0. S400 M3
G43 H1 Z25.
G84 X0. Y0. Z-12. R5. F500.
G80
(S was changed, and F was not.)
S500
G84 X10. Y0. Z-12. R5. F500. (= ! CH818 "a lead of 1 mm, and tap 1 has a pitch of 1.25 mm")
X20.
G80
G84 X30. Y0. Z-12. R5. F610.
G80
G81 X40. Y0. Z5. R5. F200. (= ! CH805 "is the R level: nothing is drilled")
G80
M30
