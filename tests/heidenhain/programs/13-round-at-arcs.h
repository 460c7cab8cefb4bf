0 BEGIN PGM BOGENECK MM
1 ; = clean
2 BLK FORM 0.1 Z X+0 Y+0 Z-10
3 BLK FORM 0.2 X+100 Y+80 Z+0
4 TOOL CALL 12 Z S3200
5 L Z+50 R0 FMAX M3
6 L X+0 Y+10 R0 FMAX ; = X+0 Y+10 Z+50
7 L Z-2 F200 ; = X+0 Y+10 Z-2
8 CC X+50 Y+30
9 ; line up to the circle of 25, rounded with 5, then round the bottom of the circle
10 L X+35 Y+10 F400
11 RND R5 ; = X+36.181 Y+9.167 ; = centre X+33.417 Y+5
12 C X+65 Y+10 DR+
13 RND R5 ; = X+66.583 Y+10 ; = centre X+66.583 Y+5
14 L X+100 Y+10 ; = X+100 Y+10 Z-2
15 L Z+50 R0 FMAX ; = X+100 Y+10 Z+50
16 M30 ; = end X+100 Y+10 Z+50
17 END PGM BOGENECK MM
