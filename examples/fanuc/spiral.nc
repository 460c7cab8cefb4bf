%
O3001 (SPIRAL POCKET)
(machine: fanuc-30i)
(Q is the change of the radius per turn, with its sign; L counts the turns begun.)
G21 G17 G90 G40 G49 G80
T1 M06
G54 G00 X0. Y2. S4000 M03
G43 H01 Z5. M08
G01 Z-3. F200.
G03 X0. Y30. I0. J-2. Q7. L4 F600.
G03 J-30. F500. (ONCE ROUND AT FULL SIZE)
G00 Z50. M09
M05
M30
%
