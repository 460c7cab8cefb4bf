(machine: linuxcnc-mill)
(set: probe.hit.Z = -4 mm)
(units: mm)
(The probe touches at Z-4; a move that does not reach it finds nothing.)
G21 G90 G17
G0 X0 Y0 Z0
G38.2 X5 Z-10 F50 (= line to X2 Z-4 | ! CH732 "touch at Z-4")
#<top>=#5063
G0 Z0
X#<top> (= rapid to X-4)
G38.3 Z-3 (= line to Z-3)
(G38.3 stays in force: an axis word alone probes again.)
Y2 (= line to Y2)
G0 Y#5070 (= rapid to Y0)
G38.2 Z-2 (= line to Z-2 | ! CH744 "touches nothing")
M2
