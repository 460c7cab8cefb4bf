(machine: linuxcnc-mill)
(LinuxCNC reads any count of digits; a double keeps about sixteen.)
G20 G17 G90 G94 S1000 M3
G0 X0 Y0 Z0
G1 X3.14159265358979323846264338327950288 F100 (= line to X3.1415926535897932)
Y000000000000000000000002.5 (= line to Y2.5)
#1 = 0.333333333333333333333333333333
Z[#1 * 3] (= line to Z1)
M2
