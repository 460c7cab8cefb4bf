(machine: fanuc-30i)
(set: tools.1.diameter="10 mm")
(set: tools.2.diameter="14 mm")
(set: tools.3.diameter="18 mm")
(Several passes along one wall. Each is quiet.)
G21 G17 G40 G90
T1 M6
S1000 M3
F200.
(1 A bore of 60 with three offsets, each smaller than the one before.)
G0 X0 Y0 Z5.
G1 Z-5.
G41 D3 X30.
G3 I-30.
G1 G40 X0
G41 D2 X30.
G3 I-30.
G1 G40 X0
G41 D1 X30.
G3 I-30.
G1 G40 X0
G0 Z5.
(2 A boss with growing offsets.)
G0 X-40. Y40.
G1 Z-5.
G41 D1 X0
Y80.
X80.
Y0
X0
Y40.
G40 X-40.
G41 D2 X0
Y80.
X80.
Y0
X0
Y40.
G40 X-40.
G41 D3 X0
Y80.
X80.
Y0
X0
Y40.
G40 X-40.
G0 Z5.
(3 The finished wall beside the rough one, each with its own offset.)
G0 X-10. Y30.
G1 Z-5.
G41 D3 X-10. Y0
X110.
G40 Y30.
X-10.
G41 D1 X-10. Y0
X110.
G40 Y30.
G0 Z5.
(4 The next offset within the contour: the same bore again with another D.)
G0 X0 Y0
G1 Z-5.
G41 D2 X30.
G3 I-30.
G1 G40 X0
D1
G41 X30.
G3 I-30.
G1 G40 X0
G0 Z5.
M30
