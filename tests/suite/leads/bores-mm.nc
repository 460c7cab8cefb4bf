(machine: fanuc-30i)
(set: tools.1.diameter="10 mm")
(Usual forms of entering and leaving a bore of 50 mm with a tool of 10 mm. Each is quiet.)
G21 G17 G40 G90
T1 M6
S1000 M3
F200.
(1 Rolled on from the centre, one full circle, rolled off to the centre.)
G0 X10. Y0 Z5.
G1 Z-5.
G41 D1 X0
G3 X25. Y0 R12.5
G3 I-25.
G3 X0 Y0 R12.5
G1 G40 X10.
G0 Z5.
(2 A half circle that comes back across the centre line, two halves.)
G0 X0 Y0
G1 Z-5.
G41 D1 X9. Y0
G3 X25. Y0 R8.
G3 X-25. Y0 R25.
G3 X25. Y0 R25.
G3 X9. Y0 R8.
G1 G40 X0
G0 Z5.
(3 Several depths in one offset; the plunge is in the wall.)
G0 X0 Y0
G1 Z-5.
G41 D1 X15. Y-10.
G3 X25. Y0 R10.
G3 I-25.
G1 Z-10.
G3 I-25.
G1 Z-15.
G3 I-25.
G3 X15. Y10. R10.
G1 G40 X0 Y0
G0 Z5.
(4 The lead-in above the part, then the plunge, the lead-out above the part again.)
G0 X10. Y0
G1 Z5.
G41 D1 X0
G3 X25. Y0 R12.5
G1 Z-5.
G3 I-25.
G1 Z5.
G3 X0 Y0 R12.5
G1 G40 X10.
(5 Half circles that grow to the size of the bore.)
G0 X0 Y0
G1 Z-5.
G41 D1 X-10.
G3 X12. Y0 R11.
G3 X-18. Y0 R15.
G3 X25. Y0 R21.5
G3 I-25.
G3 X0 Y0 R12.5
G1 G40 X5.
G0 Z5.
(6 A rough circle and the finished one beside it, both in one offset.)
G0 X0 Y0
G1 Z-5.
G41 D1 X14. Y-10.
G3 X24. Y0 R10.
G3 I-24.
G1 X25. Y0
G3 I-25.
G3 X15. Y10. R10.
G1 G40 X0 Y0
G0 Z5.
(7 Two bores in one offset, from one to the other by rapid above the part.)
G0 X10. Y0
G1 Z-5.
G41 D1 X0
G3 X25. Y0 R12.5
G3 I-25.
G3 X0 Y0 R12.5
G0 Z5.
G0 X100. Y0
G1 Z-5.
G3 X125. Y0 R12.5
G3 I-25.
G3 X100. Y0 R12.5
G1 G40 X110.
G0 Z5.
M30
