(machine: fanuc-lathe)
(set: tools.1.offset.X="-100 mm")
(set: tools.1.offset.Z="-50 mm")
(Pecks: P and Q count least increments; P is on the radius.)
G21 G18 G40 G99 G97 S800 M3
T0101
G0 X0 Z3.
G74 R1.
G74 Z-40. Q12000 F.15 (= line to X0 Z-9 | rapid to X0 Z-8 | line to X0 Z-21 | rapid to X0 Z-20 | line to X0 Z-33 | rapid to X0 Z-32 | line to X0 Z-40 | rapid to X0 Z3)
G0 X62. Z-23.
G75 R.5
G75 X40. Z-30. P3000 Q2500 F.1 (= line to X56 Z-23 | rapid to X57 Z-23 | line to X50 Z-23 | rapid to X51 Z-23 | line to X44 Z-23 | rapid to X45 Z-23 | line to X40 Z-23 | rapid to X62 Z-23 | rapid to X62 Z-25.5 | line to X56 Z-25.5 | rapid to X57 Z-25.5 | line to X50 Z-25.5 | rapid to X51 Z-25.5 | line to X44 Z-25.5 | rapid to X45 Z-25.5 | line to X40 Z-25.5 | rapid to X62 Z-25.5 | rapid to X62 Z-28 | line to X56 Z-28 | rapid to X57 Z-28 | line to X50 Z-28 | rapid to X51 Z-28 | line to X44 Z-28 | rapid to X45 Z-28 | line to X40 Z-28 | rapid to X62 Z-28 | rapid to X62 Z-30 | line to X56 Z-30 | rapid to X57 Z-30 | line to X50 Z-30 | rapid to X51 Z-30 | line to X44 Z-30 | rapid to X45 Z-30 | line to X40 Z-30 | rapid to X62 Z-30 | rapid to X62 Z-23)
(M24 x 3 in passes of equal area: not less than 0.1, 0.1 for the last, twice at the root.)
G0 X28. Z6.
G76 P021060 Q100 R100
G76 X20.376 Z-25. P1812 Q500 F3. (= rapid to X28 Z5.711325 | rapid to X23 Z5.711325 | line to X23 Z-22 | line to X28 Z-24.5 | rapid to X28 Z-25 | rapid to X28 Z6 | rapid to X28 Z5.591752 | rapid to X22.585786 Z5.591752 | line to X22.585786 Z-22 | line to X28 Z-24.707107 | rapid to X28 Z-25 | rapid to X28 Z6 | rapid to X28 Z5.5 | rapid to X22.267949 Z5.5 | line to X22.267949 Z-22 | line to X28 Z-24.866025 | rapid to X28 Z-25 | rapid to X28 Z6 | rapid to X28 Z5.42265 | rapid to X22 Z5.42265 | line to X22 Z-22 | line to X28 Z-25 | rapid to X28 Z6 | rapid to X28 Z5.354503 | rapid to X21.763932 Z5.354503 | line to X21.763932 Z-22 | line to X27.763932 Z-25 | rapid to X28 Z-25 | rapid to X28 Z6 | rapid to X28 Z5.292893 | rapid to X21.55051 Z5.292893 | line to X21.55051 Z-22 | line to X27.55051 Z-25 | rapid to X28 Z-25 | rapid to X28 Z6 | rapid to X28 Z5.235158 | rapid to X21.35051 Z5.235158 | line to X21.35051 Z-22 | line to X27.35051 Z-25 | rapid to X28 Z-25 | rapid to X28 Z6 | rapid to X28 Z5.177423 | rapid to X21.15051 Z5.177423 | line to X21.15051 Z-22 | line to X27.15051 Z-25 | rapid to X28 Z-25 | rapid to X28 Z6 | rapid to X28 Z5.119688 | rapid to X20.95051 Z5.119688 | line to X20.95051 Z-22 | line to X26.95051 Z-25 | rapid to X28 Z-25 | rapid to X28 Z6 | rapid to X28 Z5.061953 | rapid to X20.75051 Z5.061953 | line to X20.75051 Z-22 | line to X26.75051 Z-25 | rapid to X28 Z-25 | rapid to X28 Z6 | rapid to X28 Z5.011576 | rapid to X20.576 Z5.011576 | line to X20.576 Z-22 | line to X26.576 Z-25 | rapid to X28 Z-25 | rapid to X28 Z6 | rapid to X28 Z4.953841 | rapid to X20.376 Z4.953841 | line to X20.376 Z-22 | line to X26.376 Z-25 | rapid to X28 Z-25 | rapid to X28 Z6 | rapid to X28 Z4.953841 | rapid to X20.376 Z4.953841 | line to X20.376 Z-22 | line to X26.376 Z-25 | rapid to X28 Z-25 | rapid to X28 Z6)
M30
