(machine: fadal-4020)
(set: probe.hit.X = 1.5 in)
(A probe move ends at the plane that the machine file gives; PX1 to PB1 show where.)
G90 G0 X0 Y0 Z0
G31 X3. Y2. F10. (= line to X1.5 Y1 feed 10 | ! CH732 "touch at X1.5")
#R1=PX1+PY1
G0 X0 (= rapid to X0)
Y+R1 (= rapid to Y2.5)
G31 X1. (= line to X1 | ! CH744)
G31.1 X1.25 (= line to X1.25)
G31 (= ! CH745)
M2
