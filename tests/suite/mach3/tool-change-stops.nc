(machine: mach3-mill)
(set: settings.spindle_at_tool_change="stops")
G21 G90 G94
T1 M6
S2000 M3
G0 X0 Y0
G1 X10. F200.
T2 M6
G0 X0 Y10.
G1 X10. (= ! CH413 "the spindle does not turn")
S2000 M3
G1 X20.
M30
