0 BEGIN PGM F25 MM
1 ; = kind compensation without a tool call
2 BLK FORM 0.1 Z X+0 Y+0 Z-20
3 BLK FORM 0.2 X+100 Y+80 Z+0
4 L Z+50 R0 FMAX M3 ; = fault
5 L X-20 Y-20 R0 FMAX
6 L Z-3 F500 ; = fault
7 L X+5 Y+5 RL F300 ; = fault
8 L Y+75
9 L X-20 Y+100 R0
10 L Z+50 R0 FMAX
11 M30
12 END PGM F25 MM
