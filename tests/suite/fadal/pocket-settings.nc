(machine: fadal-4020)
(set: tools.2.diameter="0.5 in")
(set: settings."pocket stepover"="0.1 in")
(set: settings."pocket count"="once")
(set: settings."bore diameter word"="R2")
(What the manuals leave open is a setting: rings .1 apart, NN passed over, R2 the diameter of bores.)
M6 T2
G90 G0 S8000 M3 E1 X0 Y0
H2 D2 Z.1 M8
G1 Z-.2 F10.
L9803 R0+20. R1+0 R2+.9 (= arc ccw radius .05 sweep 180 to X.1 Y0 | arc ccw radius .1 sweep 360 | arc ccw radius .15 sweep 180 to X-.2 | arc ccw radius .2 sweep 360 | arc ccw radius .1 sweep 180 to X0 Y0)
L9401 R0+15. R2+1.5 (= arc ccw sweep 180 to X.5 Y0 | arc ccw radius .5 sweep 360 | arc ccw sweep 180 to X0 Y0)
G90 G0 Z.1
H0 Z0
M2
