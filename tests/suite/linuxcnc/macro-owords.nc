(machine: linuxcnc-mill)
(units: mm)
(O words: subroutines do not run where they stand; their locals are their own.)
G21 G90 G17 F100 S1000 M3
G0 X0 Y0 Z0
o100 sub
G1 X#1 Y#2 (= line to X10 Y20 | line to X3 Y0 | line to X5 Y0)
#1=99
#<local>=5
o100 endsub
#1=7
o100 call [10] [20]
G1 X#1 (= line to X7)
o<double> sub
o1 if [#1 GT 4]
o<double> return [0]
o1 endif
o100 call [#1]
o<double> endsub [#1*2]
o<double> call [3]
X#<_value> (= line to X6)
o<double> call [8]
X#<_value> (= line to X0)
#5=100
o[#5] call [5]
X[EXISTS[#<local>]] (= line to X0)
o2 while [#6 LT 2]
#6=[#6+1]
o3 repeat [2]
Y#6 (= line to Y1 | line to Y1 | line to Y2 | line to Y2)
o3 endrepeat
o2 endwhile
o4 do
#7=[#7+1]
o5 if [#7 EQ 1]
o4 continue (= ! CH712 "ends the loop")
o5 elseif [#7 EQ 3]
o4 break
o5 else
Z#7
o5 endif
o4 while [1]
Z0 (= line to Z0)
o<nowhere> call [1] (= ! CH201 "nowhere.ngc")
o6 perhaps (= ! CH704 "endsub")
o7 endif (= ! CH712)
o8 return (= ! CH208)
M2
