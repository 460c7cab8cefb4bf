(machine: fanuc-6m)
(set: settings.plane_codes="swapped")
(One textbook prints G18 as YZ and G19 as ZX; the setting follows it.)
G90 G00 X0. Y0. Z0. S1000 M03
G01 F7.
G18 G02 Y1. Z1. J0. K1. (= arc cw plane yz center Y0 Z1 radius 1 sweep 270)
G19 G03 Z2. X1. K1. I0. (= arc ccw plane zx)
M30
