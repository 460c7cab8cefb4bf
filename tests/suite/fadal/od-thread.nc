(machine: fadal-4020)
(Outside thread, 28 to the inch, fifteen turns down. The lead is rounded to four decimals, so)
(the last turn ends at .0357 - 15 x .0357 = -.4998.)
N47 M6 T5
N48 G90 G0 S10000 M3 X-1. Y0
N49 H5 Z.0357 M7
N50 X-.5094 G41 G1 F25. (= line to X-.5094 Y0 Z.0357)
N51 G91
N52 I.5094 G2 Z-.0357 L15 (= helix cw center X0 Y0 radius .5094 sweep 360 length 3.20085 x14 | helix to X-.5094 Y0 Z-.4998)
N53 G90
N54 X-1. G40 G0 (= rapid to X-1 Y0 Z-.4998)
N55 M5 M9
M2
