(machine: fadal-400ipm)
(The slower machine takes 250 inches a minute.)
S1000 M3
G90 G0 X0 Y0 Z0
G1 X1. F250. (= line to X1 feed 250)
X2. F251. (= line to X2 feed 251 | ! CH407 "251 in/min" "250 in/min")
M2
