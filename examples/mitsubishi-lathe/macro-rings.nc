%
O504 (RINGS PARTED IN A LOOP)
(machine: mitsubishi-lathe)
(set: tools.4.offset.X="-104 mm")
(set: tools.4.offset.Z="-54 mm")
(set: tools.5.offset.X="-105 mm")
(set: tools.5.offset.Z="-55 mm")
G21 G18 G40 G80 G99
T0505 (DRILL 14)
G97 S900 M3
G0 X0 Z5. M8
G83 Z-40. R-3. Q8000 F0.15
G80
G0 X100. Z60.
T0404 (PART 3)
G97 S800 M3
#1=-9.
WHILE[#1GE-36.]DO1
G0 X32. Z#1
G1 X13. F0.07
G0 X32.
#1=#1-9.
END1
G0 X100. Z60. M9
G28 U0 W0
M30
%
