%
(machine: fanuc-30i)
O1 (MAIN)
(Series 30i: M98 P Q begins a called program at an N number, M98 Q calls blocks of its own program.)
G21 G17 G90 S1000 M3
G0 X0. Y0. Z0.
G1 F100.
M98 P5 Q100
M98 P20005 Q100
M98 Q200 L2
M98 P5 Q999 (= none | ! CH202 "N999" "PS0078")
M98 Q998 (= none | ! CH202 "N998" "PS0078")
(Times and number in one P: the number is the program's.)
M98 P50012
M98 P51000 (= none | ! CH201 "O1000" "PS0076" "shop_codes.O1000")
M98 P120034 (= none | ! CH201 "O34")
M98 P77 L3 (= none | ! CH201 "O77")
G90
M30
N200 G91 Y1. (= line to Y1 | line to Y2)
G90 M99
O5 (THE PLACE AFTER N100)
Y100. (= none)
N100 G91 X1. (= line to X1 | line to X2 | line to X3)
G90 M99
O12
G91 Z-1. (= line to Z-1 | line to Z-2 | line to Z-3 | line to Z-4 | line to Z-5)
G90 M99
%
