%
O00002 (SETTING 58 YASNAC: A STEP LOWER THAN THE TOOL. THE MOVE TURNS ROUND, AND IF IT RAN IT WOULD CUT)
(machine: haas-vf2)
(units: mm)
(show: path)
(set: tools.1.diameter="10 mm")
(set: settings."Setting 58"=yasnac)
N1 G21 G17 G40 G90 G94 S1000 M3 F100.
N2 G0 X-40. Y20. Z0
N3 G41 D1 G1 Y0 (= line to X-40 Y5)
N4 X0 (= line to X-5 Y5)
N5 Y3. (= line to X-5 Y3 | arc cw center X0 Y3 radius 5 sweep 90.0 to X0 Y8 | ! CH508 "3 mm" "alarm 342" | ! CH530 "2 mm")
N6 X40. (= line to X40 Y8)
N7 G40 Y23. (= line to X40 Y23)
N8 M30
%
