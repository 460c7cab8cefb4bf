(machine: fadal-4020)
(set: tools.1.diameter="0.1 in")
(Probing and engraving are known, their words are judged, their motion is told to be missing.)
M6 T1
G90 G0 S8000 M3 E1 X0 Y0
H1 D1 Z.1
L9101 R1+2. (= none | ! CH312 "probe function 2")
L9101 R1+11. (= none | ! CH312 | ! CH303 "no probe function 11")
L9101 (= none | ! CH312 | ! CH820 "without R1")
L9201 Z-.01 R0+.1 R1+0 R2+.5 R3+0 F10. (PART 12 (= none | ! CH312 "PART 12")
L9201 Z-.01 R0+.1 R1+3. R2+.5 R3+0 R4+2. F10. (0001 (= none | ! CH312)
L9201 R0+.1 R1+4. R2+.5 R3+0 F10. (TEXT (= none | ! CH312 | ! CH820 "without Z" | ! CH303 "kind of letters 4")
L9201 Z-3. R0+.1 R1+0 R2+2.6 R3+0 R4+1. (TEXT (= none | ! CH312 | ! CH303 "2.6 in" | ! CH303 "3.1 in below" | ! CH303 "serial step")
G1 X1. G41 F10.
L9101 R1+1. (= none | ! CH312 | ! CH820 "compensation is on")
X0 G40
H0 D0
L9201 Z-.01 R0+.1 R1+0 R2+.5 R3+0 F10. (A (= none | ! CH312 | ! CH820 "without an active tool offset")
M2
