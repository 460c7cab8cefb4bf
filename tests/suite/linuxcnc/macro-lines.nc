(machine: linuxcnc-mill)
(units: mm)
(Parameters: an assignment holds from the next line on. Names, what the control tells, comments.)
G21 G90 G17 F100 S1000 M3
G0 X0 Y0 Z0
#3=4
#3=6 G1 X#3 (= line to X4)
G1 X#3 (= line to X6)
#1=1 #2=[#1+5] (both sides are old: #1 is 0)
X#1 Y#2 (= line to X1 Y5)
#<Long Name>=2.5
X#<longname> (= line to X2.5)
X[EXISTS[#<long name>]+EXISTS[#<other>]] (= line to X1)
Y#<other> (= none | ! CH721 "other")
#<_x>=3 (= ! CH706 "_x")
X[#<_x>+1] Y[#5421*2] (= line to X2 Y10)
X[#<_feed>/100] Y[#<_motion_mode>] Z[#<_metric>] (= line to X1 Y10 Z1)
Y##1 (= line to Y1)
(PRINT, x is #5420 and #<longname>) ;(= > " x is 1.000000 and 2.500000")
(DEBUG, %d#5420 %.2f#<longname>) ;(= > " 1 2.50")
(MSG, nothing is printed #1) ;(= none)
X[-7 MOD 3] Y[FIX[-2.5]] Z[2 ** 3 ** 2] (= line to X2 Y-3 Z64)
X[[0.1+0.2] EQ 0.3] Y[5 AND 0] Z[3 OR 0] (= line to X1 Y0 Z1)
#5602=1 (= ! CH705)
X[1/0] (= none | ! CH707 "Attempt to divide by zero")
(ABORT, too deep: #3) ;(= ! CH716 "too deep: 6")
X99 (= none)
M2
