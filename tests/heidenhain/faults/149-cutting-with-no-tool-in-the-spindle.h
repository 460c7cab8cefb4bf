0 BEGIN PGM F149 MM
1 ; = kind cutting with no tool in the spindle
2 BLK FORM 0.1 Z X+0 Y+0 Z-20
3 BLK FORM 0.2 X+100 Y+80 Z+0
4 TOOL CALL 0 Z S3000 ; = fault
5 L Z+50 R0 FMAX M3 ; = fault
6 L X-20 Y-20 R0 FMAX
7 L Z-3 F500 ; = fault
8 L X+5 Y+5 RL F300 ; = fault
9 L Y+75
10 L Y+120 R0
11 L Z+50 R0 FMAX
12 M30
13 END PGM F149 MM
