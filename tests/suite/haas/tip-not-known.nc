%
O00901
(machine: haas-vf2)
(expect: CH603)
(Nothing is known of lengths. The first tool may have set the work offset; the second has no length of its own.)
G21 G17 G40 G49 G80 G90
T1 M6
G0 G54 X20. Y20. S3000 M3
Z25.
G1 Z-5. F300.
G0 Z25.
T2 M6
G0 X30. Y20. S3000 M3
Z25.
G1 Z-5. F300. (= ! CH611 "where the tip of tool 2 is is not known: no length offset is in force")
X40.
G0 Z25.
T3 M6
S3000 M3
G43 H3 Z25.
G1 Z-5. F300.
X30.
G0 Z25.
G49
M30
%
