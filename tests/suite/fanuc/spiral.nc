(machine: fanuc-30i)
(Fanuc spirals: Q is the change of radius per turn with its sign, L counts turns begun: four and)
(a quarter are L5. Where both stand and disagree, Q is followed.)
G21 G17 G90 G94 S1000 M3
G0 X100. Y0. Z0.
G1 F100.
G02 X0 Y-57.5 I-100. Q-10. L5 (= spiral cw center X0 Y0 radius 100..57.5 sweep 1530 to X0 Y-57.5)
G0 X100. Y0.
G02 X0 Y-57.5 I-100. L5 (= spiral cw radius 100..57.5 sweep 1530)
G0 X100. Y0.
G02 X0 Y-57.5 I-100. Q-10. L4 (= spiral cw sweep 1530 | ! CH410 "L4 contradicts Q")
G0 X100. Y0.
G02 X0 Y-57.5 I-100. Q10. (= spiral cw sweep 1530 | ! CH410 "shrinks")
G0 X100. Y0.
G03 X0 Y57. I-100. Q-10. (= spiral ccw radius 100..57 sweep 1530 | ! CH410 "4.3 turns" "PS5123")
M30
