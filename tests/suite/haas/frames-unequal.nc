(machine: haas-vf2)
(set: settings."Setting 188"=2)
(Settings 188 to 190 give each axis its own factor: lines go, an arc needs equal ones in its plane.)
G20 G17 G90 G94 S500 M3
G0 X0 Y0 Z0
G51 X0 Y0
G0 X1. Y1. (= rapid to X2 Y1)
G2 X2. Y1. R.5 F10. (= ! CH431 "different scale factors")
G50
M30
