(machine: fadal-4020)
(G10 writes offset 1 at X2, then adds an inch in increments. The tool stands at X5 of the machine,)
(which was X3 of the program and is X2 then. Register 2 is written by L102.)
S1000 M3
G10 L2 P1 X2. Y0 Z0
G90 E1 G0 X3. Y0 Z0 (= rapid to X3 Y0 Z0)
G91 G10 L2 P1 X1.
G90 X0 (= rapid from X2 to X0 Y0)
G10 L102 R0+1.5
X+R2 (= rapid to X1.5)
M2
