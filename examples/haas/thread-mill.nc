%
O1001 (INSIDE THREAD 1.5-8, THREAD HOB .75 DIAMETER)
(machine: haas-vf2)
(G54: X0 Y0 in the middle of the bore, Z0 on top of the part.)
(The path is that of the tool's centre: a bore of 1.5 less the hob's .75 leaves a radius of .375.)
(The hob enters on a quarter arc that rises by a quarter of the 1/8 pitch, turns once, and leaves)
(on another quarter arc. Tangent all the way, so no mark is left on the thread.)
T1 M06 (THREAD HOB .75 DIA, 8 TPI)
G00 G90 G17 G20 G40 G49 G80
G54 X0. Y0. S1200 M03
G43 H01 Z0.1 M08
G01 Z-0.5313 F50. (START DEPTH: .5 AND A QUARTER PITCH)
G01 X0.1875 Y-0.1875 F20. (TO THE ENTRY)
G03 X0.375 Y0. I0. J0.1875 Z-0.5 F6. (IN)
G03 I-0.375 Z-0.375 F8. (ONE TURN, ONE PITCH UP)
G03 X0.1875 Y0.1875 I-0.1875 J0. Z-0.3437 (OUT)
G01 X0. Y0. F20.
G00 Z0.1 M09
G53 G49 Z0. M05
G53 Y0.
M30
%
