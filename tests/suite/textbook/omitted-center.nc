(machine: textbook-absolute-center)
(set: settings.omitted_center=zero)
(A centre word left out is zero here, not the start's own coordinate: X0 Y2 is the centre.)
G20 G17 G90 S1000 M3
G0 X1. Y2. Z0.
G1 F10.
G2 X-1. Y2. J2. (= arc cw center X0 Y2 radius 1 sweep 180 to X-1 Y2)
M30
