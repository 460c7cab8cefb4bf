(machine: fadal-4020)
(Straight cuts in one, two and all five axes; G1 and F stay until they are changed.)
N1 O1
N2 M6 T1
N3 G0 G90 S2000 M3 E1 X0 Y0 A0 B0 (= rapid to X0 Y0 A0 B0)
N4 H1 Z.1 M8 (= rapid to X0 Y0 Z.1)
N5 G1 Z-.25 F5. (= line to Z-.25 feed 5 length .35)
N6 G1 G91 X1. F10. (= line to X1 Y0 Z-.25 feed 10)
N7 X1. Y1. (= line to X2 Y1 Z-.25 feed 10 length 1.41421)
N8 X1. Y1. Z1. A360. B90. (= line to X3 Y2 Z.75 A360 B90 length 1.73205)
N9 M2
