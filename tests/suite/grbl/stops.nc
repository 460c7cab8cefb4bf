(machine: grbl)
(A sender stops at the first refused block: the blocks after it are not run.)
G21 G90
G0 X5 (= rapid to X5)
G64 (= ! CH313 "does not have this word")
G0 X9
