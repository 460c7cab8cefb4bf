(machine: fluidnc)
(Two rows of holes for shelf pins, each drilled in two steps; expressions run on the board. Written for FluidNC.)
G21 G90 G17 G94
G54
M3 S12000
G0 Z5
#<pitch> = 32
#<count> = 5
#1 = 0
O100 while [#1 LT #<count>]
#2 = [20 + #1 * #<pitch>]
G0 X#2 Y37
G1 Z-5 F180
G0 Z1
G1 Z-10 F180
G0 Z5
G0 Y263
G1 Z-5 F180
G0 Z1
G1 Z-10 F180
G0 Z5
#1 = [#1 + 1]
O100 endwhile
M5
G0 X0 Y0
M2
