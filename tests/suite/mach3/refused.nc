(machine: mach3-mill)
(set: settings."IJ Mode"="Absolute")
(What Mach3 does not have, and what is not followed. An M code that it does not list is a macro of the machine.)
G21 G90 G17
S1000 M3
F100
G0 X10 Y0
G2 X20 Y0 I15 J0 (= arc cw center X15 Y0 radius 5)
G2 X30 Y0 I24 J0 (= ! CH401 "radius 4 mm at the start, 6 mm at the end" "Radius to end of arc differs from radius to start")
G5 X1 (= ! CH301 "G5")
G38.2 Z-5 (= ! CH301 "G38.2")
G76 X1 (= ! CH301 "G76")
o100 if [1 GT 2] (= ! CH312 "LinuxCNC has")
o100 endif (= ! CH312 "LinuxCNC has")
#<deep>=2 (= ! CH700)
X[1 GT 2] (= ! CH701)
G51 A2 (= none | ! CH312 "rotary axis" | ! CH308)
G28.1 X0 Y0 (= none | ! CH312 "home switches")
M48 M49 (= ! CH302)
M30
