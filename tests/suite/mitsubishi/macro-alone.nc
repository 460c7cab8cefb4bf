%
O9100
(= none | ! CH729 "called with Q and Z")
(machine: mitsubishi-m700)
G91 G1 Z[#26/#17] F100. (= none)
G90
M99
%
