(machine: fadal-4020)
(units: inch)
(In format 1 F of a tap is the speed of the spindle: zero never cuts a thread.)
G90 G0 X0 Y0 Z.5
G84.1 G99 X1. Y0 Z-.5 R0+.2 F0 Q.05 (= ! CH814 "without a spindle speed")
G84.1 G99 X1. Y0 Z-.5 R0+.2 F300. Q.05
G80
M2
