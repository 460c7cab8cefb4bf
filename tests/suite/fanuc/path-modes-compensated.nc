(machine: fanuc-30i)
(set: tools.1.diameter = "10 mm")
(show: path)
(G09 stays with its block when compensation holds moves back.)
G21 G17 G90 G94 S1000 M3
G0 X0 Y40. Z0
G41 D1 G1 X0. Y20. F1000.
X30. (= line corner round)
G9 X60. (= line corner stop)
X90. (= line corner round)
G40 Y40.
M30
