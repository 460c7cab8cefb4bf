(machine: fadal-4020)
(set: tools.1.diameter="0.1 in")
(Probing and engraving are known, their words are judged, their motion is told to be missing.)
M6 T1
G90 G0 S8000 M3 E1 X0 Y0
H1 D1 Z.1
L9101 R1+2. (= none | ! CH306 "probe function 2")
L9101 R1+11. (= none | ! CH306 | ! CH303 "no probe function 11")
L9101 (= none | ! CH306 | ! CH820 "without R1")
L9201 Z-.01 R0+.1 R1+0 R2+.5 R3+0 F10. (PART 12 (= none | ! CH306 "PART 12")
M2
