0 BEGIN PGM F295 MM
1 ; = kind rotary axis in a block of a machine without it
2 BLK FORM 0.1 Z X+0 Y+0 Z-20
3 BLK FORM 0.2 X+100 Y+80 Z+0
4 TOOL DEF 1 L+0 R+5
5 TOOL CALL 1 Z S3000
6 L Z+50 R0 FMAX M3
7 ; machine with three axes
8 L X-20 Y+20 FMAX
9 L Z-3 A+30 F500 ; = fault
10 L X+110 F300
11 L Z+50 R0 FMAX
12 M30
13 END PGM F295 MM
