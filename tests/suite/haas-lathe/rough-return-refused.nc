(machine: haas-lathe)
(set: settings.units="mm")
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(set: settings."return of a contour"="refused")
(The same contour where the setting refuses it.)
G21 G18 G40 G99
T101
G97 S800 M03
G0 X40. Z2.
G71 P10 Q20 U.4 W.1 D5. F.3 (= none)
N10 G0 X20.
G1 Z-20.
X40.
N20 G0 Z2. (= ! CH303 "turns back in Z")
M30
