%
(machine: fluidnc)
(Parameters, expressions and flow control; nine work offsets; G28 takes the axis words next to G0.)
G21 G90 G17
G0 X5 (= rapid to X5)
#1 = 3
#<deep> = [#1 * 2]
G0 X#1 Y#<deep> (= rapid to X3 Y6)
O1 if [#1 GT 2]
G0 X7 (= rapid to X7)
O1 endif
O2 while [#1 GT 1]
#1 = [#1 - 1]
O2 endwhile
G0 X[#1 + 0.5] (= rapid to X1.5)
G59.1 G10 L2 P7 X1
G0 X0 (= rapid to X0)
G54
G43.1 Y1
G49
T1 M6
M62 P1
G2 X5 Y0 I2 J-3 P2 F300
G0 G28 X0
M30
%
