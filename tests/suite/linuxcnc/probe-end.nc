(machine: linuxcnc-mill)
(units: mm)
(Without a word in the machine file a probe move touches where it ends, which is told once.)
G21 G90 G17
G0 X0 Y0 Z0
G38.2 Z-10 F50 (= line to Z-10 feed 50 | ! CH723 "touch where they end")
G0 Z0
X#5063 Y[#5070*3] (= rapid to X-10 Y3)
G38.3 Z-20 (= line to Z-20)
G91 G38.2 X5 (= line to X-5)
G38.2 (= none | ! CH745 "point")
M2
