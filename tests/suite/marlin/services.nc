;(machine: marlin-router)
; What moves nothing is passed over, or named once where it changes something that is not simulated.
T0
M17
M84 S0
M82
M83
M75
M73 P50 R3
M105
M114
M115
M211 S0 ; (= ! CH306 "software endstops")
M106 S255 ; (= ! CH306 "laser or spindle on its output")
M107 ; (= ! CH306 "fan off")
M42 P4 S255 ; (= ! CH306 "sets a pin")
M226 P4 S1 ; (= ! CH306 "waits for a pin")
M280 P0 S90 ; (= ! CH306 "servo")
M300 S440 P100
M201 X500 Y500 ; (= ! CH306 "largest accelerations")
M203 X50 ; (= ! CH306 "largest speeds")
M204 P300 T500 ; (= ! CH306 "accelerations")
M205 J0.02 ; (= ! CH306 "junction deviation")
M220 S100 ; (= ! CH306 "feed override")
M500
M501 ; (= ! CH306 "loads the stored settings")
M503
M600 ; (= stop)
M400
G29 ; (= ! CH306 "measures the table")
G0 X1 F1000 ; S255 of M106 was no speed of a spindle (= rapid to X1)
M206 X1 ; (= ! CH312 "home positions")
