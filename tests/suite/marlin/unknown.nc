;(machine: marlin-router)
; Commands that Marlin does not have: it answers, and goes on.
G0 X1 Y1 Z5 F3000
G81 X5 Z-3 R1 F100 ; (= ! CH301 "Marlin has no G81")
G43 H1 ; (= ! CH301 "Marlin has no G43")
G41 D1 ; (= ! CH301 "Marlin has no G41")
G10 L2 P1 X5 ; (= ! CH301 "Marlin has no G10")
G40 ; (= ! CH301 "Marlin has no G40")
G94 ; (= ! CH301 "Marlin has no G94")
M6 T1 ; the tool is not changed (= ! CH301 "Marlin has no M6")
M98 P1000 ; (= ! CH301 "Marlin has no M98")
M2 ; the lines after it still run (= ! CH301 "Marlin has no M2")
G0 X2 ; (= rapid to X2)
M30 ; deletes a file: it ends nothing
G0 X3 ; (= rapid to X3)
% ; (= ! CH301 "begins with no command")
O1000 ; (= ! CH301 "begins with no command")
G5 X5 Y5 I1 J1 P1 Q1 ; (= ! CH301 "Marlin has no G5")
M7 ; (= ! CH301 "Marlin has no M7")
