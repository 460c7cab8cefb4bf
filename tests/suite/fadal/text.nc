(machine: fadal-4020)
(How a Fadal writes: no points needed, comments left open, stars, numbers of blocks with decimals,)
(G90 and G91 at any place of a block.)
N1 S1000 M3 * SPINDLE
N1.5 G90G0X0Y0Z0(NO BLANKS
N2 G1 X1 F20 (= line to X1 feed 20)
N3 X2.(OPEN Y5. (= line to X2 Y0)
X1. G91 Y1. (= line to X1 Y1)
X1. Y1. (= line to X2 Y2)
X1. G90 Y1. (= line to X3 Y1)
X0 Y0 (= line to X0 Y0)
G91 X1. G90 (= line to X1 Y0)
X0 (= line to X0)
N99999 M2
