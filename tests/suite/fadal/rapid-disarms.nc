(machine: fadal-4020)
(set: settings.rapid_disarms_arc=on)
(With this setting G0 takes the armed direction back: a centre after it has none.)
S1000 M3
G90 G0 X1. Y0 Z0 F10.
G1
I-1. G3 (= arc ccw sweep 360)
I-1. (= arc ccw sweep 360)
G0 X1. (= rapid to X1)
G1
I-1. (= none | ! CH405 "no G2 or G3 came before")
M2
