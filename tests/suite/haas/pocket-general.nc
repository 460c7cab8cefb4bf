%
O150
(machine: haas-vf2)
(set: tools.1.diameter="0.5 in")
(A pocket of 2 x 1.5. The tool's radius is .25 and K .01, so rough passes stay .26 off the walls,)
(rows stand at .26 + .4 and + .8. R.1 and Q.25 give the levels -.15 -.4 ... -1.4 and Z-1.5. The)
(last pass goes round the walls at .25. The hole is at X.9 Y.7, and the wall Y0 is its nearest.)
T1 M06
G00 G90 G17 G40 G49 G54 X0.9 Y0.7 S2000 M03
G43 H01 Z0.1 M08
G150 P1500 X0.9 Y0.7 Z-1.5 R0.1 Q0.25 J0.4 K0.01 G41 D01 F12. (= line to X.9 Y.7 Z-.15 feed 12 | line to X.9 Y.26 | line to X1.74 Y.26 | line to X1.74 Y.75 | line to X1.74 Y1.24 | line to X.26 Y1.24)
(= line to X.26 Y.26 | line to X.9 Y.26 | line to X.26 Y.66 | line to X1.74 Y.66 | line to X1.74 Y1.06 | line to X.26 Y1.06 | line to X.9 Y.7 Z-.15)
(= line to X.9 Y.7 Z-.4 feed 12 | line to X.9 Y.26 | line to X1.74 Y.26 | line to X1.74 Y.75 | line to X1.74 Y1.24 | line to X.26 Y1.24)
(= line to X.26 Y.26 | line to X.9 Y.26 | line to X.26 Y.66 | line to X1.74 Y.66 | line to X1.74 Y1.06 | line to X.26 Y1.06 | line to X.9 Y.7 Z-.4)
(= line to X.9 Y.7 Z-.65 feed 12 | line to X.9 Y.26 | line to X1.74 Y.26 | line to X1.74 Y.75 | line to X1.74 Y1.24 | line to X.26 Y1.24)
(= line to X.26 Y.26 | line to X.9 Y.26 | line to X.26 Y.66 | line to X1.74 Y.66 | line to X1.74 Y1.06 | line to X.26 Y1.06 | line to X.9 Y.7 Z-.65)
(= line to X.9 Y.7 Z-.9 feed 12 | line to X.9 Y.26 | line to X1.74 Y.26 | line to X1.74 Y.75 | line to X1.74 Y1.24 | line to X.26 Y1.24)
(= line to X.26 Y.26 | line to X.9 Y.26 | line to X.26 Y.66 | line to X1.74 Y.66 | line to X1.74 Y1.06 | line to X.26 Y1.06 | line to X.9 Y.7 Z-.9)
(= line to X.9 Y.7 Z-1.15 feed 12 | line to X.9 Y.26 | line to X1.74 Y.26 | line to X1.74 Y.75 | line to X1.74 Y1.24 | line to X.26 Y1.24)
(= line to X.26 Y.26 | line to X.9 Y.26 | line to X.26 Y.66 | line to X1.74 Y.66 | line to X1.74 Y1.06 | line to X.26 Y1.06 | line to X.9 Y.7 Z-1.15)
(= line to X.9 Y.7 Z-1.4 feed 12 | line to X.9 Y.26 | line to X1.74 Y.26 | line to X1.74 Y.75 | line to X1.74 Y1.24 | line to X.26 Y1.24)
(= line to X.26 Y.26 | line to X.9 Y.26 | line to X.26 Y.66 | line to X1.74 Y.66 | line to X1.74 Y1.06 | line to X.26 Y1.06 | line to X.9 Y.7 Z-1.4)
(= line to X.9 Y.7 Z-1.5 feed 12 | line to X.9 Y.26 | line to X1.74 Y.26 | line to X1.74 Y.75 | line to X1.74 Y1.24 | line to X.26 Y1.24)
(= line to X.26 Y.26 | line to X.9 Y.26 | line to X.26 Y.66 | line to X1.74 Y.66 | line to X1.74 Y1.06 | line to X.26 Y1.06 | line to X.9 Y.7 Z-1.5)
(= line to X.9 Y.25 | line to X1.75 Y.25 | line to X1.75 Y.75 | line to X1.75 Y1.25 | line to X.25 Y1.25 | line to X.25 Y.25)
(= line to X.9 Y.25 | line to X.9 Y.7 Z-1.5)
G40 G01 X1. (= line to X1 Y.7 Z-1.5 feed 12)
G00 Z0.1 M09
M30
N1500 G01 X2. Y0.75
Y1.5
X0
Y0
X2.
Y0.75
M99
%
