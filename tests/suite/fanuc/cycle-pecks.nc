(machine: fanuc-30i)
(set: settings."No. 5114"="1 mm")
(set: settings."No. 5115"="1 mm")
G21 G17 G90 G94 F100.
S1000 M3
G0 X0. Y0. Z20.
G98 G83 Z-20. R2. Q6. (= rapid to Z2 | line to Z-4 | rapid to Z2 | rapid to Z-3 | line to Z-10 | rapid to Z2 | rapid to Z-9 | line to Z-16 | rapid to Z2 | rapid to Z-15 | line to Z-20 | rapid to Z20)
G73 X10. (= rapid to X10 Z20 | rapid to Z2 | line to Z-4 | rapid to Z-3 | line to Z-10 | rapid to Z-9 | line to Z-16 | rapid to Z-15 | line to Z-20 | rapid to Z20)
G99 G81 X20. (= rapid to X20 Z20 | rapid to Z2 | line to Z-20 | rapid to Z2)
G98 X30. (= rapid to X30 Z2 | line to Z-20 | rapid to Z20)
G91 G81 X1. Z-5. R-18. K2 (= rapid to X31 | rapid to Z2 | line to Z-3 | rapid to Z20 | rapid to X32 | rapid to Z2 | line to Z-3 | rapid to Z20)
X1. K0 (= none)
G90 G80
G83 Z-20. R2. (= none | ! CH802)
G80
G76 X40. Z-5. R2. Q.5 P100 (= rapid to X40 | rapid to Z2 | line to Z-5 | rapid to X40.5 | rapid to Z20 | rapid to X40)
G87 X50. Z-5. R-10. Q.5 (= rapid to X50 | rapid to X50.5 | rapid to Z-10 | rapid to X50 | line to Z-5 | rapid to X50.5 | rapid to Z20 | rapid to X50)
G0 X0. (= rapid to X0)
X1. (= rapid to X1)
M30
