(machine: fanuc-30i)
(units: mm)
N1O75(THE HEAD, PACKED)
G90
G0X-1O.Y5. (= ! CH103 | rapid to X-10 Y5)
M30
