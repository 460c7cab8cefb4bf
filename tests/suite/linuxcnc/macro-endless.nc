(machine: linuxcnc-mill)
(A loop that never ends is stopped by the budget.)
G21 G90
o1 while [1]
o1 endwhile (= ! CH211)
M2
