(machine: fanuc-lathe-c)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(set: axes.C.max_velocity="3600 deg/min")
(C follows without a jump, from where it stands when polar interpolation begins.)
G21 G18 G40 G80 G98 G97 S1000 M3
T0101
G0 X40. Z5. C30.
G112
G1 C20. F100. (= line from X40 Y0 to X40 Y20)
X-40. (= line to X-40 Y20)
C0 (= line to X-40 Y0)
G113
(Half a turn later, and X is on its own side.)
G0 Z6. (= rapid from X40 C210 Z5 to X40 C210 Z6)
G0 C0
G12.1
(Straight through the centre C turns by half a turn.)
G1 X-40. F100. (= line from X40 Y0 to X-40 Y0)
G13.1
G0 Z7. (= rapid from X40 C180 Z6 to Z7)
(A circle about the centre and one beside it.)
G0 C0
G12.1
G1 X30. F100.
G3 I-15. J0 (= arc ccw center X0 Y0 sweep 360.00)
G13.1
G0 Z8. (= rapid from X30 C360 Z7)
G0 X60. C0
G12.1
G1 X50. F100.
G2 I-10. J0 (= arc cw center X30 Y0 radius 10.00 sweep 360.00)
G13.1
G0 Z9. (= rapid from X50 C0)
(1000 mm a minute 10 mm from the centre is 5730 degrees a minute for C.)
G0 X40. C0
G12.1
G1 C10. F1000.
X-40. (= line to X-40 Y10 | ! CH444 "C would turn at 5730 deg/min at radius 10 mm" "3600 deg/min" "at most 628.319 mm a minute")
C0
G13.1
M30
