0 BEGIN PGM RADIEN MM
1 ; = clean
2 BLK FORM 0.1 Z X+0 Y+0 Z-10
3 BLK FORM 0.2 X+150 Y+150 Z+0
4 TOOL CALL 6 Z S2500
5 L Z+50 R0 FMAX M3 ; = Z+50
6 L X+30 Y+85 R0 FMAX ; = X+30 Y+85 Z+50
7 L Z+2 FMAX ; = X+30 Y+85 Z+2
8 L Z-2 F100 ; = X+30 Y+85 Z-2
9 ; short way round, clockwise
10 CR X+70 Y+95 R+30 DR- F400 ; = X+70 Y+95 Z-2 ; = centre X+55.286 Y+68.856
11 L X+30 Y+85 ; = X+30 Y+85 Z-2
12 ; long way round, clockwise
13 CR X+70 Y+95 R-30 DR- ; = X+70 Y+95 Z-2 ; = centre X+44.714 Y+111.144
14 L X+80 Y+60 ; = X+80 Y+60 Z-2
15 ; semicircle
16 CR X+120 Y+60 R+20 DR+ ; = X+120 Y+60 Z-2 ; = centre X+100 Y+60
17 L X+120 Y+40 ; = X+120 Y+40 Z-2
18 CR IX-25 IY+0 R+30 DR- ; = X+95 Y+40 Z-2 ; = centre X+107.5 Y+67.272
19 CR X+75 Y+20 R-25 DR+ ; = X+75 Y+20 Z-2 ; = centre X+70.423 Y+44.577
20 L Z+50 R0 FMAX ; = X+75 Y+20 Z+50
21 M30 ; = end X+75 Y+20 Z+50
22 END PGM RADIEN MM
