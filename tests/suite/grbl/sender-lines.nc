(machine: grbl)
(Lines that senders drop or use themselves: the program goes on.)
%
G21 G90
G0 X5 (= rapid to X5)
 % 
$X
$$
?
~
G0 X6 (= rapid to X6)
$J=G91 X1 F100 (= line to X7)
(Homing: Z first, then the others.)
$H (= rapid | rapid)
G0 X1 Y2 Z3 (= rapid to X1 Y2 Z3)
G1 X2 F100 (= line to X2)
%
G0 X3 (= rapid to X3)
M2
