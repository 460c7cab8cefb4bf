(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-80 mm")
(set: tools.2.offset.X="-100 mm")
(set: tools.2.offset.Z="-80 mm")
(set: tools.3.offset.X="-100 mm")
(set: tools.3.offset.Z="-20 mm")
G21 G18 G40 G99
T0101
(V = 200 m/min reaches 4500 rpm at 200 / pi / 4500 = 14.147 mm.)
G96 S200 M3
G0 X62. Z0
G1 X-1.6 F.2 (= ! CH613 "below a diameter of 14.147 mm the spindle turns at 4500 rpm")
G0 Z2.
G50 S2500
G0 X62.
G1 X-1.6 F.2
(A hole in the centre.)
G0 X0 Z5.
G1 Z-20. F.1 (= ! CH615 "the spindle turns at 2500 rpm")
G0 Z5.
(A contour that begins there is none.)
G0 X0 Z2.
G1 Z0 F.1
G3 X20. Z-10. R10.
G1 X62.
(A thread: 120 m/min at 28 mm are 1364 rpm.)
G96 S120
G0 X28. Z6.
G32 Z-20. F2. (= ! CH614 "1364 rpm here")
G97 S800
G0 X28. Z6.
G32 Z-20. F2.
(P184 where P1840 is meant.)
G0 X28. Z6.
G76 P021060 Q100 R100
G76 X20.376 Z-25. P184 Q150 F3. (= ! CH617 "P of this thread is 0.184 mm, 0.061 times its lead of 3 mm")
(4 mm at 4000 rpm are 16 m/min, and the machine does 12.)
S4000
G0 X28. Z6.
G32 Z-20. F4. (= ! CH407 "a lead of 4 mm at 4000 rpm is a feed of 16000 mm/min, above the 12000 mm/min")
S800
(The turret turns where the tool has cut along 40 mm.)
G0 X40. Z2.
G1 Z-30. F.2
G0 X44.
Z-10.
X36.
T0202 (= ! CH616 "tool 1 is at X 36 mm, Z -10 mm: 2 mm inside of what this program cuts")
(The third tool is 60 mm longer: from Z40 it comes to Z-20.)
G0 X20. Z40.
T0303 (= ! CH616 "tool 3 comes to X 20 mm, Z -20 mm: 10 mm inside of what this program cuts")
G0 X200. Z100.
M30
