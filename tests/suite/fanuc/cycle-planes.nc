(machine: fanuc-30i)
(set: settings."No. 5101#0"=1)
(Along the normal of the plane in all three planes, both returns.)
G21 G90 G94 F100.
S1000 M3
G0 X0. Y0. Z0.
G0 Y20.
G18 G98 G81 X10. Z5. Y-5. R2. (= rapid to X10 Y20 Z5 | rapid to Y2 | line to Y-5 | rapid to Y20)
G99 X20. (= rapid to X20 Y20 Z5 | rapid to Y2 | line to Y-5 | rapid to Y2)
G76 X30. Q.5 (= rapid to X30 | line to Y-5 | rapid to Z5.5 | rapid to Y2 | rapid to Z5)
G80
G0 X20.
G19 G98 G82 Y10. Z5. X-5. R2. P100 (= rapid to X20 Y10 Z5 | rapid to X2 | line to X-5 | rapid to X20)
G99 G73 Y20. Q4. (= rapid to Y20 | rapid to X2 | line to X-2 | rapid to X-1 | line to X-5 | rapid to X2)
G80
G17 G0 Z20.
G98 G85 X10. Y0. Z-5. R2. (= rapid to X10 Y0 | rapid to Z2 | line to Z-5 | line to Z2 | rapid to Z20)
G41 D1 G80
G81 X0. Z-5. R2. (= none | ! CH806)
G80 G40
M30
