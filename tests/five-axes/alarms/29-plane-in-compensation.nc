(A plane while compensation is on.)
(machine: ac)
G21 G17 G90 G94 G40 G49 G80
G28 G91 Z0.
G90
T2 M06
G54 S6000 M03
G43 H2 Z50.
G1 X20. Y20. F500.
G41 D2 Y0.
X40.
G68.2 J30. (= !)
G40 Y20.
M30
