(machine: mitsubishi-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-80 mm")
G21 G18 G40 G99
T0101
M3
G0 X0 Z5.
(Nothing gives the spindle a speed.)
G84 Z-15. R-2. F1.5 (= ! CH819 "the spindle has no speed")
G80
G97 S800
G84 Z-15. R-2. F1.5
G80
G0 X28. Z6.
G76 P021060 Q100 R100
G76 X20.376 Z-25. P18400 Q500 F3. (= ! CH617 "P of this thread is 18.4 mm, 6.13 times its lead of 3 mm")
G0 X28. Z6.
G76 X20.376 Z-25. P1840 Q500 F3.
G0 X200. Z100.
M30
