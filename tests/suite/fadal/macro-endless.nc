(machine: fadal-4020)
(A loop that never ends is stopped by the budget.)
G90 G0 X0 Y0 Z0
#:LOOP ' (= ! CH211)
#V1=V1+1
#GOTO :LOOP
M2
