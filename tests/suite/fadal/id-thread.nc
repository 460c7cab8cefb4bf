(machine: fadal-4020)
(Inside thread, fifteen turns up: -.5 + 15 x .0357 = .0355.)
(total: helices 15)
N47 M6 T5
N48 G90 G0 S10000 M3 X0 Y0
N49 H5 Z.1 M7
N50 Z-.5 G1 F50. (= line to X0 Y0 Z-.5)
N51 X.5313 G41 G1 F25. (= line to X.5313)
N52 G91
N53 I-.5313 G3 Z.0357 L15 (= helix ccw center X0 Y0 radius .5313 sweep 360 x14 | helix to X.5313 Y0 Z.0355)
N54 G90
N55 X0 G40 G0 (= rapid to X0 Y0 Z.0355)
M2
