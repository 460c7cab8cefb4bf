(machine: haas-vf2)
(Worked examples of the Haas manual, whole.)
G20 G17 G90 G94 F10.
S1000 M3
(From G99 to G98 the way to the second hole is at R.)
G0 X1. Y-.5 Z2.
G81 G99 X1. Z-.5 R.1 (= rapid to Z.1 | line to Z-.5 | rapid to Z.1)
G98 X2. (= rapid to X2 Y-.5 Z.1 | line to Z-.5 | rapid to Z2)
X4. (= rapid to X4 Y-.5 Z2 | rapid to Z.1 | line to Z-.5 | rapid to Z2)
G80
(O60810: nine holes in a grid, all to Z-1.5.)
G0 X1. Y-1. Z1.
G99 G81 Z-1.5 R.1 (= rapid to X1 Y-1 Z.1 | line to Z-1.5 | rapid to Z.1)
G91 X1. L2 (= rapid to X2 Y-1 Z.1 | line to Z-1.5 | rapid to Z.1 | rapid to X3 Y-1 Z.1 | line to Z-1.5 | rapid to Z.1)
G90 Y-2. (= rapid to X3 Y-2 Z.1 | line to Z-1.5 | rapid to Z.1)
G91 X-1. L2 (= rapid to X2 Y-2 Z.1 | line to Z-1.5 | rapid to Z.1 | rapid to X1 Y-2 Z.1 | line to Z-1.5 | rapid to Z.1)
G90 Y-3. (= rapid to X1 Y-3 Z.1 | line to Z-1.5 | rapid to Z.1)
G91 X1. L2 (= rapid to X2 Y-3 Z.1 | line to Z-1.5 | rapid to Z.1 | rapid to X3 Y-3 Z.1 | line to Z-1.5 | rapid to Z.1)
G80 G90
(The same line of five holes in G90.)
G0 X0. Y0. Z.1
G99 G81 X1.25 Z-.2 (= rapid to X1.25 Y0 Z.1 | line to Z-.2 | rapid to Z.1)
X2.5 (= rapid to X2.5 | line to Z-.2 | rapid to Z.1)
X3.75 (= rapid to X3.75 | line to Z-.2 | rapid to Z.1)
X5. (= rapid to X5 | line to Z-.2 | rapid to Z.1)
X6.25 (= rapid to X6.25 | line to Z-.2 | rapid to Z.1)
G80
(G70: I5 J15 L12, each place to 1e-4.)
G0 X0. Y0. Z1.
G99 G81 Z-1. R.1 L0 (= none)
G70 I5. J15. L12 (= rapid to X4.8296291 Y1.2940952 Z1 | rapid to Z.1 | line to Z-1 | rapid to Z.1 | rapid to X3.5355339 Y3.5355339 | line to Z-1 | rapid to Z.1 | rapid to X1.2940952 Y4.8296291 | line to Z-1 | rapid to Z.1)
(= rapid to X-1.2940952 Y4.8296291 | line to Z-1 | rapid to Z.1 | rapid to X-3.5355339 Y3.5355339 | line to Z-1 | rapid to Z.1 | rapid to X-4.8296291 Y1.2940952 | line to Z-1 | rapid to Z.1)
(= rapid to X-4.8296291 Y-1.2940952 | line to Z-1 | rapid to Z.1 | rapid to X-3.5355339 Y-3.5355339 | line to Z-1 | rapid to Z.1 | rapid to X-1.2940952 Y-4.8296291 | line to Z-1 | rapid to Z.1)
(= rapid to X1.2940952 Y-4.8296291 | line to Z-1 | rapid to Z.1 | rapid to X3.5355339 Y-3.5355339 | line to Z-1 | rapid to Z.1 | rapid to X4.8296291 Y-1.2940952 | line to Z-1 | rapid to Z.1)
G80
(E: the spindle turns the other way after the hole, and back. P: at the last peck alone.)
G0 X0. Y0. Z1.
G81 X1. Z-.5 R.1 E300. (= rapid to X1 | rapid to Z.1 | line to Z-.5 | rapid to Z.1 | spindle ccw | spindle cw)
G80
G83 X2. Z-.5 R.1 Q.4 P200 (= rapid to X2 | line to Z-.3 | rapid to Z.1 | rapid to Z-.28 | line to Z-.5 | dwell .2 | rapid to Z.1)
G82 X3. Z-.5 P.5 (= rapid to X3 | line to Z-.5 | dwell .5 | rapid to Z.1)
G80
M30
