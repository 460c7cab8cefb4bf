(machine: fadal-4020)
(set: tools.1.diameter="0.5 in")
(set: tools.2.diameter="0 in")
(The rules of the fixed routines. None of these blocks moves.)
M6 T1
G90 G0 S8000 M3 E1 X0 Y0
Z.1
L9601 R0+10. R1+0 R2+3. R3+2. (= none | ! CH820 "no tool offset" "IMPROPER USE OF CANNED SUBR.")
H2 D2 Z.1 (= ! CH604)
L9601 R0+10. R1+0 R2+3. R3+2. (= none | ! CH820 "diameter of tool 2 is zero")
H1 D1 Z.1
G1 Z-.1 F10.
L9601 R0+10. R1+0 R3+2. (= none | ! CH820 "without R2")
L9801 R1+0 (= none | ! CH820 "without R0, R2")
L9601 R0+10. R1+.25 R2+3. R3+2. (= none | ! CH820 "0.25 in")
L9601 R0+10. R1+.3 R2+3. R3+2. (= none | ! CH820 "0.3 in leaves no flat")
L9601 R0+10. R1+0 R2+3. R3+.4 (= none | ! CH821 "0.5 in" "0.4 in")
L9801 R0+10. R1+0 R2+.4 (= none | ! CH821 "0.5 in" "0.4 in")
L9601 R0+0 R1+0 R2+3. R3+2. (= none | ! CH820 "feed zero")
L9600 R0+10. R1+0 R2+3. R3+2. (= none | ! CH303 "no pass")
L9400 R0+10. R1+3. (= none | ! CH303 "no pass")
L9601 R0+10. R1+0 R2+3.00001 R3+.50000 (= line to X1.250005 | line to X-1.250005 | line to X0 Y0)
X1. G41
L9601 R0+10. R1+0 R2+3. R3+2. (= none | ! CH820 "compensation is on")
X0 G40
G0 Z.2
G81 G99 R0+.1 Z-.2 F20. X0 Y0
L9601 R0+10. R1+0 R2+3. R3+2. (= none | ! CH820 "cycle is active")
G80
G1 L9301 (= none | ! CH807 "L93")
L9601 R0+450. R1+0 R2+3. R3+.5 (= line x3 | ! CH407 "450 in/min")
G0 Z.1
H0 Z0
M2
