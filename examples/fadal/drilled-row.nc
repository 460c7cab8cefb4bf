(machine: fadal-4020)
(A row of holes by one line, a deep one, and tapped holes: Q is the lead and F the speed.)
M6 T1
G20 G17 G90 G40 G80
G0 X0 Y0 S1800 M3 E1
H1 Z1. M8
G81 G99 Z-.6 R0+.1 F8. X.5 Y.5
G91 X.5 L4
G90 G80
G83 G98 X1.5 Y1.5 Z-1.5 R0+.1 Q.3 F6.
G80
M5 M9
H0 Z0
M6 T2
G0 X0 Y0 S500 M3 E1
H2 Z1. M8
G84 G98 Z-.5 R0+.2 Q.05 F500. X.5 Y.5
X1.
X1.5
G80
M5 M9
H0 Z0
M2
