(machine: fanuc-30i)
(set: tools.3.length='130 mm')
(Axis words next to a code: whether they move, and what is said where they do not.)
G21 G17 G90 G94 S500 M3
G0 X0 Y0 Z0 (= rapid to X0 Y0 Z0)
(G22 takes X Y Z I J K as the limits of its region.)
G22 X200. Y200. Z100. I-200. J-200. K-200. (= none)
G23
(G96 takes P; X moves.)
G96 S200 X5. (= rapid to X5 Y0 | ! CH306)
G97 S500
(A dwell takes X or P for its time, and no other axis.)
G4 P100 Y3. (= none | ! CH304)
(G39 without compensation has no use for them.)
G39 X5. (= none | ! CH304)
(An angle and a centre of the plane; Z is no centre in G17.)
G68 X0 Y0 Z5. R90. (= ! CH304)
G69
M30
