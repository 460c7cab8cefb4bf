(machine: fadal-4020)
(G9 stops in position after every block and is taken to be in force at power-on; G8 runs on.)
G90 S1000 M3
G1 X1. F40. (= line corner stop)
G8 X2. (= line corner round)
X3. (= line corner round)
G9 X4. (= line corner stop)
X5. (= line corner stop)
M30
