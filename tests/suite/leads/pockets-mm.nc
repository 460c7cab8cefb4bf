(machine: fanuc-30i)
(set: tools.1.diameter="10 mm")
(Usual forms of entering and leaving a pocket of 80 by 60 mm, corners of 8, with a tool of 10 mm.)
(Each is quiet. The pocket's middle is X0 Y0.)
G21 G17 G40 G90
T1 M6
S1000 M3
F200.
(1 A line from the middle to the middle of a wall, and back.)
G0 X0 Y0 Z5.
G1 Z-5.
G41 D1 X0 Y-30.
X32.
G3 X40. Y-22. R8.
G1 Y22.
G3 X32. Y30. R8.
G1 X-32.
G3 X-40. Y22. R8.
G1 Y-22.
G3 X-32. Y-30. R8.
G1 X0
G40 Y0
G0 Z5.
(2 A line and a quarter circle from the middle; a quarter circle and a line back.)
G0 X0 Y0
G1 Z-5.
G41 D1 X-10. Y-20.
G3 X0 Y-30. R10.
G1 X32.
G3 X40. Y-22. R8.
G1 Y22.
G3 X32. Y30. R8.
G1 X-32.
G3 X-40. Y22. R8.
G1 Y-22.
G3 X-32. Y-30. R8.
G1 X0
G3 X10. Y-20. R10.
G1 G40 X0 Y0
G0 Z5.
(3 Rolled on from the middle by a half circle, rolled off to the middle.)
G0 X5. Y0
G1 Z-5.
G41 D1 X0 Y0
G3 X0 Y-30. R15.
G1 X32.
G3 X40. Y-22. R8.
G1 Y22.
G3 X32. Y30. R8.
G1 X-32.
G3 X-40. Y22. R8.
G1 Y-22.
G3 X-32. Y-30. R8.
G1 X0
G3 X0 Y0 R15.
G1 G40 X-5.
G0 Z5.
(4 As the second, run 5 mm past the start.)
G0 X0 Y0
G1 Z-5.
G41 D1 X-10. Y-20.
G3 X0 Y-30. R10.
G1 X32.
G3 X40. Y-22. R8.
G1 Y22.
G3 X32. Y30. R8.
G1 X-32.
G3 X-40. Y22. R8.
G1 Y-22.
G3 X-32. Y-30. R8.
G1 X5.
G3 X15. Y-20. R10.
G1 G40 X0 Y0
G0 Z5.
(5 Begun in the fillet of a corner, run past the start of it.)
G0 X0 Y-10.
G1 Z-5.
G41 D1 X29.172 Y-27.657
G3 X37.657 Y-27.657 I4.242 J4.243
G3 X40. Y-22. I-5.657 J5.657
G1 Y22.
G3 X32. Y30. R8.
G1 X-32.
G3 X-40. Y22. R8.
G1 Y-22.
G3 X-32. Y-30. R8.
G1 X32.
G3 X40. Y-22. R8.
G1 Y-10.
G3 X30. Y0 R10.
G1 G40 X0 Y0
G0 Z5.
(6 G42, the other way round.)
G0 X0 Y0
G1 Z-5.
G42 D1 X10. Y-20.
G2 X0 Y-30. R10.
G1 X-32.
G2 X-40. Y-22. R8.
G1 Y22.
G2 X-32. Y30. R8.
G1 X32.
G2 X40. Y22. R8.
G1 Y-22.
G2 X32. Y-30. R8.
G1 X0
G2 X-10. Y-20. R10.
G1 G40 X0 Y0
G0 Z5.
(7 Down a ramp along the walls for one turn, then level.)
G0 X0 Y0
G1 Z0
G41 D1 X-10. Y-20.
G3 X0 Y-30. R10.
G1 X32. Z-.5
G3 X40. Y-22. R8. Z-.7
G1 Y22. Z-1.5
G3 X32. Y30. R8. Z-1.7
G1 X-32. Z-2.8
G3 X-40. Y22. R8. Z-3.
G1 Y-22. Z-4.
G3 X-32. Y-30. R8. Z-4.2
G1 X0 Z-5.
X32.
G3 X40. Y-22. R8.
G1 Y22.
G3 X32. Y30. R8.
G1 X-32.
G3 X-40. Y22. R8.
G1 Y-22.
G3 X-32. Y-30. R8.
G1 X0
G3 X10. Y-20. R10.
G1 G40 X0 Y0
G0 Z5.
(8 A helix in the middle of the pocket with the offset, then on to the wall.)
G0 X0 Y0
G1 Z0
G41 D1 Y-12.
G3 J12. Z-2.5
G3 J12. Z-5.
G3 J12.
G1 X20. Y-30.
X32.
G3 X40. Y-22. R8.
G1 Y22.
G3 X32. Y30. R8.
G1 X-32.
G3 X-40. Y22. R8.
G1 Y-22.
G3 X-32. Y-30. R8.
G1 X20.
G3 X30. Y-20. R10.
G1 G40 X0 Y0
G0 Z5.
(9 An island of 10 mm in the pocket: the walls, a line to it, round it, and back.)
G0 X0 Y20.
G1 Z-5.
G41 D1 X-10. Y20.
G1 X-20. Y30.
G1 X-32.
G3 X-40. Y22. R8.
G1 Y-22.
G3 X-32. Y-30. R8.
G1 X32.
G3 X40. Y-22. R8.
G1 Y22.
G3 X32. Y30. R8.
G1 X-20.
G1 X0 Y5.
G2 J-5.
G1 G40 Y18.
G0 Z5.
(10 A rough pass .5 mm off the walls and the finished one, in one offset.)
G0 X0 Y0
G1 Z-5.
G41 D1 X-10. Y-19.5
G3 X0 Y-29.5 R10.
G1 X32.
G3 X39.5 Y-22. R7.5
G1 Y22.
G3 X32. Y29.5 R7.5
G1 X-32.
G3 X-39.5 Y22. R7.5
G1 Y-22.
G3 X-32. Y-29.5 R7.5
G1 X0
Y-30.
G1 X32.
G3 X40. Y-22. R8.
G1 Y22.
G3 X32. Y30. R8.
G1 X-32.
G3 X-40. Y22. R8.
G1 Y-22.
G3 X-32. Y-30. R8.
G1 X0
G3 X10. Y-20. R10.
G1 G40 X0 Y0
G0 Z5.
M30
