(machine: fadal-4020)
(set: settings."feed ramps" = "G8")
(set: settings."G8 rounding" = "0.002 in")
G90 S1000 M3
G1 X1. F40. (= line corner round .002)
G9 X2. (= line corner stop)
M30
