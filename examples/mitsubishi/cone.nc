%
O2001 (SPIRALS AND CONES, TYPE 1)
(machine: mitsubishi-m700)
(A flat spiral inwards, then a cone: G2.1 with P full turns beside the angle of the ends.)
G21 G17 G90 G40 G49 G80
T1 M06
G54 G00 X100. Y0. S3000 M03
G43 H01 Z5. M08
G01 Z-1. F200.
G02.1 X20. Y0. I-100. J0. P4 F800. (RADIUS 100 TO 20 IN FOUR TURNS)
G01 Z-2. F200.
G03.1 X60. Y0. Z-12. I-20. J0. P5 F600. (A CONE: OUT TO 60, TEN DEEPER)
G00 Z50. M09
M05
M30
%
