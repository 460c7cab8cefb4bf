0 BEGIN PGM MATRIX MM
1 ; = clean
2 ; 3 rows of 4 points, spotted by hand; the block above is run r + 1 times
3 BLK FORM 0.1 Z X+0 Y+0 Z-10
4 BLK FORM 0.2 X+100 Y+80 Z+0
5 TOOL CALL 28 Z S2000 F200
6 L Z+50 R0 FMAX M3
7 L X-10 Y+10 FMAX ; = X-10 Y+10
8 L Z+2 FMAX ; = X-10 Y+10 Z+2
9 LBL 1
10 LBL 2
11 L IX+20 FMAX ; = X+70 Y+60 Z+2 ; = runs 12
12 L Z-2.5 F AUTO
13 L Z+2 FMAX ; = X+70 Y+60 Z+2 ; = runs 12
14 CALL LBL 2 REP 3
15 L X-10 IY+25 FMAX ; = X-10 Y+85 Z+2 ; = runs 3
16 CALL LBL 1 REP 2
17 L Z+50 FMAX ; = X-10 Y+85 Z+50
18 M30 ; = end X-10 Y+85 Z+50
19 END PGM MATRIX MM
