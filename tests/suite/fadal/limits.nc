(machine: fadal-4020)
(The largest radius, without and with compensation, the largest turn and the largest feed.)
S1000 M3 D1
G90 G0 X0 Y0 Z0
G1 F400. (= none)
X1. R0+399.9999 G2 (= arc cw radius 399.9999 to X1 Y0)
X2. R0+400. G2 (= arc cw radius 400 to X2 Y0 | ! CH408 "400 in" "399.9999 in")
G41 X3. (= line to X3)
X4. R0+99.9999 G2 (= arc cw to X4)
X5. R0+100. G2 (= arc cw to X5 | ! CH408 "100 in" "99.9999 in" "compensation")
G40 X6. (= line to X6)
A1080. (= line to A1080)
A2161. (= line to A2161 | ! CH415 "1081")
(F1000. is an angle per minute where rotary axes turn alone: the limit of lengths does not hold.)
A1441. F1000. (= line to A1441 feed 1000)
F400.1 (= none | ! CH407 "400.1 in/min" "400 in/min")
X7. (= line to X7)
M2
