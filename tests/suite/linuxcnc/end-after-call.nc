(machine: linuxcnc-mill)
(units: mm)
(Without an end: told at the call that came last, not inside the called program.)
o100 sub
G0 X[#1] (= rapid to X10)
o100 endsub
G21 G90
G50
o100 call [10] (= ! CH205)
