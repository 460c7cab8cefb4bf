;(machine: marlin-router)
; At power-on the coordinates are those of the machine; G92 writes the active system.
G0 X10 Y10 Z5 F3000
G92 X0 Y0 Z0
G0 X5 ; (= rapid to X5 length 5)
G53 G0 X20 ; the machine's X20 is X10 here (= rapid to X10 length 5)
G0 X0 ; (= rapid to X0 length 10)
G54 ; another system: what G92 wrote stays with the first
G92 X100
G0 X101 ; (= rapid to X101 length 1)
G53 ; alone: the machine's system again, with what G92 wrote
G0 X0 ; (= rapid to X0 length 1)
G92.1 ; zero again: the position is X10 Y10 Z5 of the machine
G0 X11 ; (= rapid to X11 length 1)
G28 X ; bare letters: X alone goes to its switch (= rapid to X0 length 11)
G28 X50 Z ; numbers say nothing (= rapid to X0 Z0 length 5)
G28 ; all (= rapid to X0 Y0 Z0 length 10)
G0 X3 Y4 ; (= rapid to X3 Y4 length 5)
G92 X0 Y0
G28 ; the shift of homed axes is gone (= rapid length 5)
G0 X3 ; (= rapid to X3 length 3)
G55
G28 X ; (= ! CH312 "depends on the version")
